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
