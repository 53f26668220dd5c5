/** Which of several contacts the views of one contact show. */
export class Shown {
  contact = 0;
  private readonly listeners_: (() => void)[] = [];

  listen(listener: () => void): void {
    this.listeners_.push(listener);
  }

  choose(contact: number): void {
    if (contact === this.contact) return;
    this.contact = contact;
    for (const listener of this.listeners_) listener();
  }
}
