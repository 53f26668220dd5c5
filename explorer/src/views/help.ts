/** The keys, on a sheet that "?" opens. */
import { button, h } from "../draw/dom.ts";

const groups: readonly [string, readonly [string, string][]][] = [
  [
    "Everywhere",
    [
      ["?", "this sheet"],
      ["t", "the tour"],
      ["d", "the other direction"],
      ["p", "play or pause the motion"],
      ["x", "A ⇄ B while listening"],
      ["Alt + ← →", "back and forward: every step can be undone"],
    ],
  ],
  [
    "Noise chart",
    [
      ["click", "run the cell"],
      ["drag", "zoom into a rectangle"],
      ["double click, -", "unzoom"],
      ["+", "zoom about the cell"],
      ["← → ↑ ↓", "move the cell, with shift by eight"],
    ],
  ],
  [
    "Response",
    [
      ["wheel, + -", "zoom"],
      ["drag, ← →", "move"],
      ["click", "bring the mechanism to this time"],
      ["Home, double click", "the whole motion"],
    ],
  ],
  [
    "Rubbing system",
    [
      ["space", "play or pause"],
      ["← →", "step, with shift further"],
    ],
  ],
];

export class Help {
  readonly element: HTMLDialogElement;

  constructor(cases: readonly string[]) {
    const numbers: [string, string] = [`1 … ${cases.length}`, `the cases: ${cases.join(", ")}`];
    const all = groups.map(
      ([title, keys], k) => [title, k === 0 ? [...keys.slice(0, 2), numbers, ...keys.slice(2)] : keys] as const,
    );
    this.element = h(
      "dialog",
      { "id": "help", "aria-labelledby": "help-title" },
      h(
        "div",
        { class: "heading" },
        h("h2", { id: "help-title" }, "Keys"),
        h("span", { class: "spacer" }),
        button("Close", () => this.element.close()),
      ),
      ...all.map(([title, keys]) =>
        h(
          "section",
          {},
          h("h3", {}, title),
          h("dl", {}, ...keys.flatMap(([key, what]) => [h("dt", {}, h("kbd", {}, key)), h("dd", {}, what)])),
        ),
      ),
    );
    this.element.addEventListener("click", (event) => event.target === this.element && this.element.close());
  }

  toggle(): void {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
