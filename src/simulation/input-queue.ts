import type { InputAction, InputEvent } from './input';

/**
 * Least simulated time that a button or pad stays down, in µs. The board notices a press after up to 44 ms; chosen: a
 * quick tap, which a program that looks every 100 ms sees as well.
 */
export const LEAST_DOWN_US = 100_000;

/** Least simulated time that it stays up before it goes down again, in µs. Chosen: enough to count as let go. */
export const LEAST_UP_US = 60_000;

/** A press that would come later than this becomes one with the press before it, in µs. Chosen: six quick taps. */
const LATEST_US = 1_000_000;

/** A button or pad goes down or up. */
interface Press {
  /** Id of its sensor and its device. */
  readonly id: string;
  readonly down: boolean;
}

/**
 * The inputs to a run that wait for their time. Fingers, keys, hosts and scripts may press and let go in one breath; the
 * board would never notice. So what comes live is spread here, in simulated time: each button and pad stays as it is for
 * at least `LEAST_DOWN_US` or `LEAST_UP_US`. What is replayed has its times already and keeps them.
 */
export class InputQueue {
  /** In order of time. */
  private readonly waiting: InputEvent[];
  /** The last change of each button and pad, by sensor id, whether it still waits or is done. */
  private readonly changes = new Map<string, { readonly down: boolean; readonly timeUs: number }>();

  /** @param inputs what is replayed, in any order */
  constructor(inputs: readonly InputEvent[]) {
    this.waiting = [...inputs].sort((a, b) => a.timeUs - b.timeUs);
  }

  get isEmpty(): boolean {
    return this.waiting.length === 0;
  }

  /** The inputs that take effect at `timeUs` or before, in order of time. */
  until(timeUs: number): readonly InputEvent[] {
    const later = this.waiting.findIndex((event) => event.timeUs > timeUs);
    return later < 0 ? this.waiting : this.waiting.slice(0, later);
  }

  /** Adds an action for a time of its own, after those of the same time. */
  addAt(timeUs: number, action: InputAction, device?: string): void {
    this.waiting.splice(this.until(timeUs).length, 0, { timeUs, ...(device !== undefined && { device }), action });
  }

  /** Adds what is done now: a press for the time at which the board has noticed the change before it. */
  add(action: InputAction, nowUs: number, device?: string): void {
    const press = pressOf(action, device);
    if (press === null) return this.addAt(nowUs, action, device);
    const last = this.changes.get(press.id);
    if (last?.down === press.down) return; // nothing new
    const timeUs = last ? Math.max(nowUs, last.timeUs + (last.down ? LEAST_DOWN_US : LEAST_UP_US)) : nowUs;
    if (last && press.down && timeUs > nowUs + LATEST_US) return this.takeBack(press.id, last.timeUs);
    this.changes.set(press.id, { down: press.down, timeUs });
    this.addAt(timeUs, action, device);
  }

  /** Takes out the next action that is due, `null` when none is. */
  takeDue(nowUs: number): InputEvent | null {
    const [next] = this.waiting;
    if (next === undefined || next.timeUs > nowUs) return null;
    this.waiting.shift();
    const press = pressOf(next.action, next.device);
    if (press && (this.changes.get(press.id)?.timeUs ?? 0) <= nowUs)
      this.changes.set(press.id, { down: press.down, timeUs: nowUs });
    return next;
  }

  /** Cancels the release at `timeUs`, so that the button stays down. */
  private takeBack(id: string, timeUs: number): void {
    const place = this.waiting.findLastIndex(
      (event) => event.timeUs === timeUs && pressOf(event.action, event.device)?.id === id,
    );
    this.waiting.splice(place, 1);
    this.changes.set(id, { down: true, timeUs: timeUs - LEAST_DOWN_US });
  }
}

/** The button or pad that an action presses or lets go; `null`: it does something else. */
function pressOf(action: InputAction, device = ''): Press | null {
  const press = (sensor: string, down: boolean): Press => ({ id: `${sensor} ${device}`, down });
  if (action.type === 'button') return press(action.button === 'a' ? 'buttonA' : 'buttonB', action.down);
  if (action.type === 'touch') return press(action.pad, action.down);
  if (action.type === 'remote' || action.type === 'gamepad') return press(`${action.type}-${action.key}`, action.down);
  if (action.type !== 'sensor' || typeof action.value !== 'number' || !/^(button|pin)/.test(action.id)) return null;
  return press(action.id, action.value >= 0.5);
}
