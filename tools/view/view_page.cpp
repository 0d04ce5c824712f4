#include "tools/view/view_page.h"

#include "tools/report/page/embedded.h"
#include "tools/report/page/html.h"

namespace warplut {
namespace {

std::string Chooser(const PageMoment& moment, const char* side, std::size_t chosen) {
  std::string options;
  for (std::size_t i = 0; i < moment.layers.size(); ++i) {
    const std::string text = EscapeHtml(moment.layers[i].name);
    options += i == chosen ? Element("option",
                                     {{"value", std::to_string(i)}, {"selected", "selected"}}, text)
                           : Element("option", {{"value", std::to_string(i)}}, text);
  }
  return Element("select", {{"class", side}, {"aria-label", std::string(side) + " side"}}, options);
}

std::string MomentHtml(const PageMoment& moment) {
  std::string layers;
  for (std::size_t i = 0; i < moment.layers.size(); ++i) {
    const PageLayer& layer = moment.layers[i];
    const char* place = i == 0 ? "layer left" : i == 1 ? "layer right" : "layer";
    layers += VoidElement("img", {{"class", place},
                                  {"src", DataUri("image/png", layer.png)},
                                  {"alt", moment.title + ": " + layer.name}});
  }
  const std::string slider = VoidElement("input", {{"type", "range"},
                                                   {"min", "0"},
                                                   {"max", "100"},
                                                   {"value", "50"},
                                                   {"aria-label", "border between the sides"}});
  const std::string buttons = Element("button", {{"type", "button"}, {"class", "flip"}}, "flip") +
                              Element("button", {{"type", "button"}, {"class", "zoom"}}, "1 : 1");
  const std::string figure = Element(
      "figure", {{"class", "moment"}, {"tabindex", "0"}},
      Element("div", {{"class", "bar"}},
              Chooser(moment, "left", 0) + buttons + Chooser(moment, "right", 1)) +
          slider +
          Element("div", {{"class", "frame"}}, Element("div", {{"class", "stack"}}, layers)) +
          Element("figcaption", {}, EscapeHtml(moment.caption)));
  return Element("section", {{"id", moment.id}},
                 Element("h2", {}, EscapeHtml(moment.title)) + figure) +
         "\n";
}

}  // namespace

std::string ViewPage(const std::string& title, const std::vector<std::string>& paragraphs,
                     const std::vector<PageMoment>& moments) {
  std::string head = Element("h1", {}, EscapeHtml(title)), links, body;
  for (const std::string& text : paragraphs) head += Element("p", {}, EscapeHtml(text));
  for (const PageMoment& moment : moments) {
    links += Element("a", {{"href", "#" + moment.id}}, EscapeHtml(moment.title)) + " ";
    body += MomentHtml(moment);
  }
  return "<!doctype html>\n" +
         Element(
             "html", {{"lang", "en"}},
             Element("head", {},
                     VoidElement("meta", {{"charset", "utf-8"}}) +
                         VoidElement("meta", {{"name", "viewport"},
                                              {"content", "width=device-width, initial-scale=1"}}) +
                         Element("title", {}, EscapeHtml(title)) +
                         Element("style", {}, embedded::kViewStyle)) +
                 "\n" +
                 Element("body", {},
                         Element("header", {}, head + Element("nav", {}, links)) + "\n" +
                             Element("main", {}, body) +
                             Element("script", {}, embedded::kViewScript))) +
         "\n";
}

}  // namespace warplut
