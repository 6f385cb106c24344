import type { Clip, Copies } from '#editor/clipboard';

/** The last copied objects. They stay until something else is copied, even if another course is opened. */
export class Clipboard {
  private held: { readonly clip: Clip; readonly text: string } | null = null;
  /** The copies that were made last by duplicating: the next ones go on from there. */
  copies: Copies | null = null;
  /** The system's clipboard has been given the text: another one there is newer. */
  isWithSystem = false;

  get isEmpty(): boolean {
    return this.held === null;
  }

  get clip(): Clip | null {
    return this.held?.clip ?? null;
  }

  /** The copied objects as text for the system's clipboard. */
  get text(): string | null {
    return this.held?.text ?? null;
  }

  take(clip: Clip, text: string): void {
    this.held = { clip, text };
    this.isWithSystem = false;
  }
}
