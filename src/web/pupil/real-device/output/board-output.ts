import type { BoardText } from '../../../session/run/board/real-board';

/** Most characters that are kept. Chosen: far more than anybody scrolls through, and little memory. */
const MOST_CHARACTERS = 200_000;

/** The text that a board sends, from the last start of its program on. */
export class BoardOutput {
  /** Number of the program's start. */
  start = 0;
  gone = 0;
  private readonly texts: BoardText[] = [];
  private characters = 0;
  private startMs = 0;
  private isOver = true;

  get all(): readonly BoardText[] {
    return this.texts;
  }

  /** Notes that the program may be another one from now on. What it said can be read until the next says something. */
  end(nowMs: number): void {
    this.isOver = true;
    this.startMs = nowMs;
  }

  write(came: string, nowMs: number): void {
    const text = came.replaceAll('\0', ''); // the flasher fills the line with them
    if (text === '') return;
    if (this.isOver) this.begin();
    this.texts.push({ device: 0, text, timeUs: Math.round((nowMs - this.startMs) * 1000) });
    this.characters += text.length;
    while (this.characters > MOST_CHARACTERS) {
      this.characters -= this.texts.shift()?.text.length ?? this.characters;
      this.gone += 1;
    }
  }

  private begin(): void {
    this.isOver = false;
    this.start += 1;
    this.texts.length = 0;
    this.characters = 0;
    this.gone = 0;
  }
}
