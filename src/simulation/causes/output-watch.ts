import type { Board } from '#board/board';
import type { Wire } from '#board/wires/wire';
import type { Clock } from '#core/clock';
import type { LedChain } from '#devices/led-chains';
import type { RobotOutput } from '#robots/robot';
import { readFrames } from '#vm/debug/frames';
import type { Inspected } from '#vm/debug/inspected';
import { Names } from '#vm/debug/names';
import type { Observer } from '#vm/run/vm';
import type { CodeLine, Output, OutputSet } from './output';

/** The device whose program is watched. */
export interface WatchedDevice {
  readonly board: Board;
  readonly clock: Clock;
  /** The robot's wires, see `Robot.wires`. */
  readonly wires: () => Readonly<Record<string, readonly RobotOutput[]>>;
  readonly chains: () => readonly LedChain[];
  readonly inspect: () => Inspected;
  readonly tell: (set: OutputSet) => void;
}

/** Calls of the device (`_hal`) by which something else is shown. */
const DISPLAY_CALLS: ReadonlySet<string> = new Set(
  ['show_image', 'show_text', 'clear', 'blank', 'run', 'scroll', 'set_pixel', 'on', 'off', 'rotate'].map(
    (call) => `display_${call}`,
  ),
);
const SOUND_CALLS: ReadonlySet<string> = new Set([
  ...['music_play', 'music_pitch', 'audio_effect', 'audio_open', 'speech_say'],
]);
const SILENCE_CALLS: ReadonlySet<string> = new Set([
  ...['music_stop', 'music_silence', 'audio_stop', 'audio_stop_effect', 'speech_stop'],
]);
/** Calls whose first value is the number of the pin that they set. */
const PIN_CALLS: ReadonlySet<string> = new Set(['pin_write', 'pin_write_analog', 'pin_set_period']);
/** Calls after which the board is as if it had just been switched on. */
const RESET_CALLS: ReadonlySet<string> = new Set(['reset', 'reboot']);

const DARK = '0'.repeat(25);
const NEWLINE = 10;
const RETURN = 13;

/**
 * Reports each output that a program sets, with the lines that do it. It only reads: the run stays the same. Give it to
 * the VM as its observer, and `onSet` to the robot.
 */
export class OutputWatch implements Observer {
  private names: Names | null = null;
  private namesOf: Inspected | null = null;
  private isInCall = false;
  private lines: readonly CodeLine[] | null = null;
  private isLineStart = true;
  /** Outputs of the board that were set. */
  private readonly known = new Set<Output>();

  constructor(private readonly of: WatchedDevice) {}

  readonly onSet = (output: RobotOutput, value: string | number): void => {
    // What a robot does by itself, no line does.
    if (this.isInCall) this.tell(output, value);
  };

  before(): void {
    this.isInCall = true;
    this.lines = null;
  }

  after(call: string, given: readonly unknown[]): void {
    if (DISPLAY_CALLS.has(call)) this.setOnBoard('display', this.displayed(call));
    else if (SOUND_CALLS.has(call)) this.setOnBoard('sound', null);
    else if (SILENCE_CALLS.has(call)) this.setOnBoard('sound', 'off');
    else if (PIN_CALLS.has(call)) this.setPin(given[0]);
    else if (call === 'ws2812_write') this.setLights(given[0]);
    else if (call === 'radio_send' && this.of.board.radio.isOn) this.tell('radio', null);
    else if (call === 'log_row' && given[1] === true) this.tell('log', null);
    else if (call === 'power_off') for (const output of ['display', 'sound'] as const) this.setOnBoard(output, 'off');
    else if (RESET_CALLS.has(call)) for (const output of this.known) this.tell(output, null);
    this.isInCall = false;
  }

  print(bytes: Uint8Array): void {
    this.lines = null;
    for (const byte of bytes) {
      const isEnd = byte === NEWLINE || byte === RETURN;
      if (this.isLineStart && !isEnd) this.tell('console', null);
      this.isLineStart = byte === NEWLINE || (this.isLineStart && isEnd);
    }
  }

  private displayed(call: string): string | null {
    const { display } = this.of.board;
    if (call === 'display_clear') return DARK;
    return display.isAnimating ? null : Array.from(display.pixels).join('');
  }

  private setPin(number: unknown): void {
    const wire = this.wireOf(number);
    if (wire === null) return;
    for (const output of this.outputsOf(wire)) this.setOnBoard(output, stateOf(wire));
    this.setMotors(wire);
  }

  /** The outputs that a wire carries: the robot's own if the robot uses it, else the pin itself. */
  private outputsOf(wire: Wire): readonly Output[] {
    return this.of.wires()[wire.name] ?? [`pin-${wire.name}`];
  }

  private setMotors(wire: Wire): void {
    const { board } = this.of;
    const { motors } = board.type;
    for (const [place, { dirPin, speedPin }] of (motors?.outputs ?? []).entries())
      if ([dirPin, speedPin, motors?.modePin ?? ''].some((name) => board.pin(name).wire === wire))
        this.setOnBoard(`motor-${place}`, board.motors[place]?.duty ?? 0);
  }

  /** Reports the LEDs on a pin: the board's own or a plugged-in chain. A robot reports its own LEDs itself. */
  private setLights(number: unknown): void {
    const { board } = this.of;
    const wire = this.wireOf(number);
    if (wire === null) return;
    const { rgb } = board.type;
    const chain = this.of.chains().find(({ pin }) => pin === wire.name);
    if (rgb !== null && board.pin(rgb.pin).wire === wire) this.setOnBoard('board-lights', board.rgb.join());
    else if (chain !== undefined) this.tell(`chain-${wire.name}`, chain.colors.join());
  }

  private wireOf(number: unknown): Wire | null {
    for (const pin of this.of.board.pins.values()) if (pin.number === number) return pin.wire;
    return null;
  }

  private setOnBoard(output: Output, value: OutputSet['value']): void {
    this.known.add(output);
    this.tell(output, value);
  }

  private tell(output: Output, value: OutputSet['value']): void {
    this.lines ??= this.linesNow();
    this.of.tell({ output, timeUs: this.of.clock.nowUs, value, lines: this.lines });
  }

  private linesNow(): readonly CodeLine[] {
    const inspected = this.of.inspect();
    if (this.namesOf !== inspected) {
      this.namesOf = inspected;
      this.names = new Names(inspected.memory, inspected.interned);
    }
    return readFrames(inspected, this.names ?? undefined).map(({ code, line }) => ({ file: code.file, line }));
  }
}

/** The state into which a program has brought a wire. */
function stateOf(wire: Wire): string {
  const { pwm } = wire;
  return pwm === null ? `${wire.level}` : `${pwm.dutyFraction} of ${pwm.periodUs}`;
}
