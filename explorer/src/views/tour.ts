/** Two minutes for a student: predict, then try. It waits for the running model, which alone says what is right. */
import { sentence } from "../data/api.ts";
import type { Simulation } from "../data/types.ts";
import { button, h, setText } from "../draw/dom.ts";
import { withValues, type Design, type State } from "../state/state.ts";
import type { Store } from "../state/store.ts";
import { questions, type Question } from "./questions.ts";

type Stage = "closed" | "shown" | "trying" | "answered" | "end";

export class Tour {
  readonly element: HTMLElement;
  private readonly title_ = h("h2", { id: "tour-title", tabindex: -1 });
  private readonly text_ = h("p", { id: "tour-text" });
  private readonly answers_ = h("div", { "class": "answers", "role": "group", "aria-label": "Your prediction" });
  private readonly result_ = h("p", { id: "tour-result", role: "status" });
  private readonly next_ = button("Next", () => this.step_(), { id: "tour-next", class: "primary" });
  private readonly show_ = button("Do it for me", () => this.do_(), { id: "tour-do" });
  private readonly stay_ = button("Stay here", () => this.close_(), { id: "tour-stay" });
  private readonly leave_ = button("Leave the tour", () => this.leave(), {
    id: "tour-leave",
    class: "quiet",
    title: "Back to where you were (Esc)",
  });
  private stage_: Stage = "closed";
  private at_ = 0;
  private foretold_ = 0;
  private predicted_ = "";
  private shown_: Simulation | null = null;
  private last_: { simulation: Simulation; design: Design } | null = null;
  private before_: State | null = null; // what the tour was begun from

  constructor(private readonly store_: Store) {
    this.element = h(
      "section",
      { "id": "tour", "class": "tour", "role": "dialog", "aria-labelledby": "tour-title", "hidden": true },
      this.title_,
      this.text_,
      this.answers_,
      this.result_,
      h("div", { class: "bar" }, this.next_, this.show_, this.stay_, h("span", { class: "spacer" }), this.leave_),
    );
    this.element.addEventListener("keydown", (event) => event.key === "Escape" && this.leave());
  }

  begin(): void {
    if (this.stage_ !== "closed") return this.title_.focus();
    this.before_ = this.store_.state;
    this.foretold_ = 0;
    this.element.hidden = false;
    this.open_(0);
  }

  /** Back to what was there before, at any time. */
  leave(): void {
    if (this.before_) this.store_.update(this.before_);
    this.close_();
  }

  /** The model has spoken: of the question's design, or of what was made of it. */
  know(simulation: Simulation, design: Design): void {
    this.last_ = { simulation, design };
    if (this.stage_ === "closed" || this.stage_ === "end") return;
    if (JSON.stringify(design) === JSON.stringify(this.question_.design)) {
      this.shown_ = simulation;
      if (this.stage_ === "shown") this.offer_(simulation);
    } else if (this.stage_ === "trying" && this.shown_ && this.question_.task?.isDone(this.shown_, simulation)) {
      void this.judge_(simulation, design);
    }
  }

  private get question_(): Question {
    return questions[this.at_] as Question;
  }

  private open_(at: number): void {
    this.at_ = at;
    this.stage_ = "shown";
    this.shown_ = null;
    const { title, text, design, view } = this.question_;
    setText(this.title_, `${at + 1} of ${questions.length}: ${title}`);
    setText(this.text_, text);
    setText(this.result_, "");
    this.answers_.replaceChildren();
    this.point_(null);
    this.offerSteps_([]);
    this.title_.focus();
    this.store_.update({ design, view, direction: "going", span: null, other: null });
    if (view !== "response") document.getElementById(`view-${view}`)?.scrollIntoView({ block: "start" });
    if (this.last_) this.know(this.last_.simulation, this.last_.design); // nothing runs anew if it is of this design
  }

  private offer_(shown: Simulation): void {
    if (this.answers_.childElementCount > 0) return;
    this.answers_.replaceChildren(
      ...this.question_
        .choices(shown)
        .map(([value, text]) =>
          button(text, () => this.predict_(value), { "data-answer": value, "aria-pressed": "false" }),
        ),
    );
  }

  private predict_(value: string): void {
    if (this.stage_ !== "shown" || !this.shown_) return;
    this.predicted_ = value;
    for (const each of this.answers_.querySelectorAll("button")) {
      each.setAttribute("aria-pressed", String(each.dataset.answer === value));
      each.disabled = true;
    }
    const { task, design } = this.question_;
    if (!task) return void this.judge_(this.shown_, design);
    this.stage_ = "trying";
    setText(this.result_, task.text);
    this.offerSteps_([this.show_]);
    this.point_(task.key);
    // somebody may have moved a slider before choosing
    if (JSON.stringify(this.store_.state.design) !== JSON.stringify(design)) this.store_.update({ design });
  }

  private do_(): void {
    const { task, design } = this.question_;
    if (task) this.store_.update({ design: withValues(design, { [task.key]: task.to }) });
  }

  private async judge_(tried: Simulation, design: Design): Promise<void> {
    this.stage_ = "answered";
    this.point_(null);
    const question = this.question_;
    const right = question.answer(tried) === this.predicted_;
    if (right) ++this.foretold_;
    this.offerSteps_([this.next_]);
    setText(this.result_, "…");
    let says: string;
    try {
      says = await question.says(tried, design);
    } catch (error) {
      says = sentence(error);
    }
    if (this.stage_ !== "answered" || this.question_ !== question) return;
    this.result_.dataset.right = String(right);
    setText(this.result_, `${right ? "✓ As you said." : "✗ Not as you said."} ${says}`);
  }

  private step_(): void {
    if (this.at_ + 1 < questions.length) return this.open_(this.at_ + 1);
    this.stage_ = "end";
    setText(this.title_, "That was the tour");
    setText(
      this.text_,
      `You predicted ${this.foretold_} of ${questions.length}. A noise may need no stick at all, and the way that a ` +
        "joint leans decides which way it sounds. From here: click anywhere on the chart, or ask Keep quiet for the " +
        "smallest change that silences a design.",
    );
    setText(this.result_, "");
    this.answers_.replaceChildren();
    this.offerSteps_([this.stay_]);
    this.title_.focus();
  }

  /** Shows these steps; the one that is ready to be taken gets the focus that a vanished button had. */
  private offerSteps_(steps: HTMLButtonElement[]): void {
    const had = this.element.contains(document.activeElement);
    for (const each of [this.next_, this.show_, this.stay_]) each.hidden = !steps.includes(each);
    if (had) steps[0]?.focus();
  }

  private close_(): void {
    this.stage_ = "closed";
    this.point_(null);
    this.element.hidden = true;
    document.getElementById("tour-button")?.focus();
  }

  /** Marks the row of a control; null: none. */
  private point_(key: string | null): void {
    for (const row of document.querySelectorAll(".pointed")) row.classList.remove("pointed");
    const row = key ? document.querySelector(`[data-row="${key}"]`) : null;
    row?.classList.add("pointed");
    row?.scrollIntoView({ block: "center" });
  }
}
