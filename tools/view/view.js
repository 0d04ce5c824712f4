"use strict";
for (const moment of document.querySelectorAll(".moment")) {
  const stack = moment.querySelector(".stack"), slider = moment.querySelector("input");
  const layers = [...stack.querySelectorAll(".layer")];
  const show = () => {
    stack.style.setProperty("--cut", slider.value + "%");
    stack.classList.toggle("flipped", slider.value === "0" || slider.value === "100");
  };
  // The image of each side, as its list says.
  for (const side of ["left", "right"]) {
    const chooser = moment.querySelector("select." + side);
    chooser.addEventListener("change", () => {
      for (const layer of layers) layer.classList.remove(side);
      layers[Number(chooser.value)].classList.add(side);
    });
  }
  slider.addEventListener("input", show);
  // All of the left side, then all of the right one.
  const flip = () => {
    slider.value = slider.value === "100" ? 0 : 100;
    show();
  };
  moment.querySelector(".flip").addEventListener("click", flip);
  moment.addEventListener("keydown", (event) => {
    if (event.key !== " " || event.target !== moment) return;
    event.preventDefault();
    flip();
  });
  // Pixels of the image: as wide as the page, one to one, two, four.
  const zooms = [["1 : 1", 0], ["2 : 1", 1], ["4 : 1", 2], ["fit", 4]];
  let zoom = 0;
  const button = moment.querySelector(".zoom");
  button.addEventListener("click", () => {
    zoom = (zoom + 1) % zooms.length;
    const [next, factor] = zooms[zoom];
    button.textContent = next;
    stack.style.width = factor ? layers[0].naturalWidth * factor / devicePixelRatio + "px" : "";
  });
}
