import type { Clip } from '#editor/clipboard';

/** What was copied last. It stays until something else is, also when another course is opened. */
export class Clipboard {
  private clip: Clip | null = null;
  private pastes = 0;

  get isEmpty(): boolean {
    return this.clip === null;
  }

  take(clip: Clip): void {
    this.clip = clip;
    this.pastes = 0;
  }

  /** What is to be pasted, and for which time. `null`: nothing was copied. */
  next(): { readonly clip: Clip; readonly time: number } | null {
    if (this.clip === null) return null;
    this.pastes += 1;
    return { clip: this.clip, time: this.pastes };
  }
}
