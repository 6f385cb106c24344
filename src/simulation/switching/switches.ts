import { textBytesOf } from '#board/radio-text';
import type { Board } from '#board/board';
import { beginsOn, type Switching } from '#scene/kinds/switching';

/** The boards that may switch something; the wires are those of the first one without a robot, else of the first. */
export function switchingBoards(
  devices: readonly { readonly board: Board; readonly mounted: unknown }[],
): readonly SwitchingBoard[] {
  const pins = devices.find(({ mounted }) => mounted === null) ?? devices[0];
  return devices.map((device) => ({ board: device.board, hasPins: device === pins }));
}

/** Something in the arena that is switched: a lamp, a barrier. */
export interface Switchable {
  /** `null`: it is always on. */
  readonly switching: Switching | null;
  /** Switches it on or opens it. */
  set(isOn: boolean): void;
  /** Whether it shines, or is open, now. */
  isOn(): boolean;
}

/** A board that may switch something. */
export interface SwitchingBoard {
  readonly board: Board;
  /** True if it is the one whose wires switch. */
  readonly hasPins: boolean;
}

/**
 * Switches lamps and barriers as the course says, before each step of the world: by the time, by texts and presses since
 * the last step, by the level of a wire, by hand. Nothing happens in it where nothing is switched.
 */
export class Switches {
  private readonly wanted = new Map<string, boolean>();
  private known: ReadonlyMap<string, Switchable> = new Map();
  private packets: Uint8Array[] = [];
  private readonly down = new Map<string, boolean>();
  private isListening = false;
  /** Those of `known` that are not always on. */
  private switched: readonly (readonly [id: string, thing: Switchable])[] = [];
  private hasButtons = false;
  private hasTime = false;

  /** @param things what can be switched now, by object id: another map whenever it has changed */
  constructor(
    private readonly things: () => ReadonlyMap<string, Switchable>,
    private readonly boards: readonly SwitchingBoard[],
  ) {
    this.renew();
  }

  /** Which things shine or are open now, by object id; `undefined` in a course without anything that can be switched. */
  get states(): Readonly<Record<string, boolean>> | undefined {
    if (this.known.size === 0) return undefined;
    return Object.fromEntries(Array.from(this.known, ([id, thing]) => [id, thing.isOn()]));
  }

  /** True if something is switched by the time: it goes on when all programs have ended. */
  get awaitsTime(): boolean {
    return this.hasTime;
  }

  /** Switches what is switched by hand. */
  byHand(id: string, isOn: boolean): void {
    if (this.things() !== this.known) this.renew();
    if (this.known.get(id)?.switching !== 'hand') return;
    this.wanted.set(id, isOn);
    this.known.get(id)?.set(isOn);
  }

  /** A packet is on the air. */
  hear(packet: Uint8Array): void {
    if (this.isListening && this.switched.length > 0) this.packets.push(packet);
  }

  /** Call it before each step of the world. */
  step(nowUs: number): void {
    if (this.things() !== this.known) this.renew();
    if (this.switched.length === 0) return;
    const happened = { nowUs, texts: this.packets.splice(0).map(textOf), pressed: this.takePresses() };
    for (const [id, thing] of this.switched) {
      const isOn = this.next(id, thing.switching, happened);
      if (isOn === this.wanted.get(id)) continue;
      this.wanted.set(id, isOn);
      thing.set(isOn);
    }
  }

  /** Takes over what the course has now. A thing that was there before keeps its state. */
  private renew(): void {
    this.known = this.things();
    for (const id of this.wanted.keys()) if (!this.known.has(id)) this.wanted.delete(id);
    for (const [id, thing] of this.known) {
      const isOn = this.wanted.get(id) ?? beginsOn(thing.switching);
      this.wanted.set(id, isOn);
      thing.set(isOn);
    }
    this.switched = [...this.known].filter(([, { switching }]) => switching !== null);
    this.hasButtons = this.has((switching) => 'button' in switching);
    this.hasTime = this.has((switching) => 'time' in switching);
    if (this.isListening || !this.has((switching) => 'radio' in switching)) return;
    this.isListening = true;
    for (const { board } of this.boards) board.radio.onSend((packet) => this.hear(packet));
  }

  private next(id: string, switching: Switching | null, { nowUs, texts, pressed }: Happened): boolean {
    const before = this.wanted.get(id) ?? false;
    if (switching === null) return true;
    if (switching === 'hand') return before;
    if ('time' in switching) return isInFirstPart(nowUs, switching.time);
    if ('pin' in switching) return this.boards.some(({ board, hasPins }) => hasPins && isHigh(board, switching.pin));
    if ('button' in switching) return pressed.includes(switching.button) ? !before : before;
    return texts.reduce((is, text) => after(is, text, switching.radio), before);
  }

  /** The buttons that went down since the last step. */
  private takePresses(): readonly ('a' | 'b')[] {
    if (!this.hasButtons) return [];
    return (['a', 'b'] as const).flatMap((button) =>
      this.boards.flatMap(({ board }, place) => {
        const { isDown } = button === 'a' ? board.buttonA : board.buttonB;
        const key = `${button}${place}`;
        const wasDown = this.down.get(key) ?? false;
        this.down.set(key, isDown);
        return isDown && !wasDown ? [button] : [];
      }),
    );
  }

  private has(is: (switching: Exclude<Switching, 'hand'>) => boolean): boolean {
    for (const { switching } of this.known.values())
      if (switching !== null && switching !== 'hand' && is(switching)) return true;
    return false;
  }
}

/** Everything since the last step that may switch something. */
interface Happened {
  readonly nowUs: number;
  readonly texts: readonly (string | null)[];
  readonly pressed: readonly ('a' | 'b')[];
}

/** True during the first of two spans of time that follow each other without end; in whole µs. */
function isInFirstPart(nowUs: number, [on, off]: readonly [number, number]): boolean {
  const [onUs, offUs] = [Math.round(on * 1e6), Math.round(off * 1e6)];
  return nowUs % (onUs + offUs) < onUs;
}

/** The state after a text; the same text for on and off switches over. */
function after(isOn: boolean, text: string | null, [on, off]: readonly [string, string]): boolean {
  if (text === null) return isOn;
  if (on === off) return text === on ? !isOn : isOn;
  return text === on || (isOn && text !== off);
}

function textOf(packet: Uint8Array): string | null {
  const bytes = textBytesOf([...packet]);
  return bytes && new TextDecoder().decode(bytes);
}

const isHigh = (board: Board, pin: string): boolean =>
  board.type.pins.some(({ wire }) => wire === pin) && board.wire(pin).fraction >= 0.5;
