/** Short ways to make elements. */

type Child = Node | string | null;
type Attributes = Record<string, string | number | boolean | null | EventListener>;

/** An element with attributes, listeners (`onclick`) and children; null and false attributes are left out. */
export function h<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(key.replace(/^on/, ""), value);
    else if (value !== null && value !== false) element.setAttribute(key, value === true ? "" : String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null));
  return element;
}

export function button(label: string, action: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return h("button", { type: "button", ...attributes, onclick: action }, label);
}

/** A choice of a few, with its label. */
export function select(
  label: string,
  options: readonly (readonly [value: string, text: string])[],
  change: (value: string) => void,
  attributes: Attributes = {},
): HTMLSelectElement {
  const element = h("select", { "aria-label": label, ...attributes, "onchange": () => change(element.value) });
  setOptions(element, options);
  return element;
}

export function setOptions(element: HTMLSelectElement, options: readonly (readonly [string, string])[]): void {
  const wanted = options.map(([value, text]) => `${value}\n${text}`).join("\n\n");
  if (element.dataset.options === wanted) return;
  const value = element.value;
  element.dataset.options = wanted;
  element.replaceChildren(...options.map(([value, text]) => h("option", { value }, text)));
  if (options.some(([each]) => each === value)) element.value = value;
}

/** A symbol with what stands below it. */
export function symbol(parts: readonly [string, string]): HTMLElement {
  return h("i", { class: "symbol" }, parts[0], parts[1] ? h("sub", {}, parts[1]) : null);
}

/**
 * A menu below its button. Esc closes it, and a click or the focus beside it does; the focus goes back to the button
 * unless something else has taken it. What was typed and not yet taken is forgotten with Esc.
 *
 * @param open is called each time when it opens
 */
export function menu(label: string, sheet: HTMLElement, attributes: Attributes = {}, open?: () => void): HTMLElement {
  const summary = h("summary", {}, label);
  const element = h("details", { class: "drop", ...attributes }, summary, sheet);
  const close = (): void => {
    element.open = false;
    if (element.contains(document.activeElement) || document.activeElement === document.body) summary.focus();
  };
  const beside = (event: Event): void => {
    // a file is handed over by a click that no hand made
    if (event.isTrusted && !element.contains(event.target as Node)) close();
  };
  const escape = (event: KeyboardEvent): void => {
    if (event.key !== "Escape") return;
    for (const input of sheet.querySelectorAll("input")) input.value = input.defaultValue;
    close();
    event.stopPropagation();
  };
  element.addEventListener("toggle", () => {
    const change = element.open ? "addEventListener" : "removeEventListener";
    document[change]("click", beside, true);
    document[change]("focusin", beside);
    document[change]("keydown", escape as EventListener, true);
    if (element.open) open?.();
  });
  return element;
}

/** Puts text where it differs, so that nothing is announced or laid out anew without need. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export function download(name: string, blob: Blob): void {
  const address = URL.createObjectURL(blob);
  const link = h("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
