import type { Clip } from '#editor/clipboard';

/** What was last copied. It stays until something else is copied, even if another course is opened. */
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

  /** What to paste, and for how many times by now, this one included. `null`: nothing was copied. */
  next(): { readonly clip: Clip; readonly time: number } | null {
    if (this.clip === null) return null;
    this.pastes += 1;
    return { clip: this.clip, time: this.pastes };
  }
}
