/** Lines that are kept. */
const LINES = 50; // chosen: more than anyone goes back

/** The lines that were sent, to be called up again with the arrow keys; what was being typed comes back at the end. */
export class InputHistory {
  private lines: readonly string[] = [];
  /** Index of the shown line; `lines.length`: the one that is being typed. */
  private place = 0;
  private draft = '';

  /** Adds a line that is sent. Empty ones and repetitions are not kept. */
  add(line: string): void {
    if (line.trim() !== '' && line !== this.lines.at(-1)) this.lines = [...this.lines, line].slice(-LINES);
    this.place = this.lines.length;
    this.draft = '';
  }

  /** The line before the shown one. @param shown what is in the field now */
  earlier(shown: string): string {
    if (this.place === this.lines.length) this.draft = shown;
    this.place = Math.max(0, this.place - 1);
    return this.lines[this.place] ?? this.draft;
  }

  /** The line after the shown one. @param shown what is in the field now */
  later(shown: string): string {
    if (this.place === this.lines.length) return shown;
    this.place += 1;
    return this.lines[this.place] ?? this.draft;
  }
}
