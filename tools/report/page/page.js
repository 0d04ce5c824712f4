"use strict";
// Tables: a click on a column's name sorts by it, again the other way round. Cells that begin with a number come before others.
for (const table of document.querySelectorAll("table")) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    head.querySelector("button").addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const text = (row) => (row.cells[column] ? row.cells[column].textContent.trim() : "");
      const order = (a, b) => {
        const x = parseFloat(text(a)), y = parseFloat(text(b));
        if (isNaN(x) !== isNaN(y)) return isNaN(x) ? 1 : -1;
        const less = isNaN(x) ? text(a).localeCompare(text(b)) : x - y;
        return down ? -less : less;
      };
      table.tBodies[0].append(...[...table.tBodies[0].rows].sort(order));
    });
  });
}
// Pictures: the slider moves the border between the two.
for (const pair of document.querySelectorAll(".pair")) {
  const stack = pair.querySelector(".stack");
  pair.querySelector("input").addEventListener("input", (event) => {
    stack.style.setProperty("--cut", event.target.value + "%");
  });
}
// On paper nothing is folded.
addEventListener("beforeprint", () => {
  for (const folded of document.querySelectorAll("details")) folded.open = true;
});
