import type { PinMode, PinType, TouchKind } from '../boards/board-type';
import type { PwmOutput, PwmUnit } from './pwm-unit';
import type { Level, Pull, SerialFrame, Wire, WireEnd } from './wire';

export type { PinMode } from '../boards/board-type';

/** Modes that hold a pin: taking it for something else gives the device's "Pin %d in %q mode". */
const HOLDING_MODES: ReadonlySet<PinMode> = new Set<PinMode>(['display', 'button', 'music', 'i2c', 'spi']);

const DEFAULT_PULL: Pull = 'down'; // codal-microbit-v2: DEVICE_DEFAULT_PULLMODE

/** The present action of the pin's own end on the wire. */
type Role = 'nothing' | 'input' | 'level' | 'pwm' | 'tone' | 'touch' | 'bus';

/**
 * The microcomputer's own end of a wire, as a Python program knows it.
 *
 * `acquire` says whether a use is allowed. The calls that use the pin acquire it themselves and throw an Error if it is
 * held, so call `acquire` first. Source of the modes: micropython-microbit-v2 microbit_pinmode.c and microbit_pin.c.
 */
export class Pin {
  private readonly end: WireEnd;
  private readonly output: PwmOutput;
  private role: Role = 'nothing';
  private currentMode: PinMode;
  private currentPull: Pull = DEFAULT_PULL;
  private chosenPull: Pull | null = null;

  constructor(
    readonly type: PinType,
    readonly wire: Wire,
    private readonly pwm: PwmUnit,
  ) {
    this.currentMode = type.startMode;
    this.end = wire.connect(type.name);
    this.output = {
      show: (signal) => (signal.dutyFraction > 0 ? this.end.drivePwm(signal) : this.end.drive(0)),
    };
  }

  /** Python name: `pin0`. */
  get name(): string {
    return this.type.name;
  }

  /** The number in the device's messages. */
  get number(): number {
    return this.type.number;
  }

  get mode(): PinMode {
    return this.currentMode;
  }

  /** The resistor used while the pin is a digital input; `down` after a start. */
  get pull(): Pull {
    return this.currentPull;
  }

  /**
   * The result of `get_pull()`: the resistor that was chosen last. Before the first choice it is `up` (0), although the
   * input then pulls down. The device does the same (microbithal.cpp, pin_pull_state).
   */
  get reportedPull(): Pull {
    return this.chosenPull ?? 'up';
  }

  /** The shared PWM period in µs, or -1 while this pin is not an analog output. */
  get analogPeriodUs(): number {
    return this.role === 'pwm' ? this.pwm.periodUs : -1;
  }

  /**
   * Takes the pin for a use. A button's pin may be read without being taken.
   *
   * @returns `null` on success, otherwise the mode that holds it: ValueError "Pin 3 in display mode" (`busyMessage`)
   */
  acquire(mode: PinMode): PinMode | null {
    if (this.currentMode === mode) return null;
    if (this.currentMode === 'button' && mode === 'read_digital') return null;
    if (HOLDING_MODES.has(this.currentMode)) return this.currentMode;
    this.currentMode = mode;
    return null;
  }

  /** Releases the pin from any use; its own end then drives nothing. */
  free(): void {
    this.currentMode = 'unused';
    this.become('nothing');
    this.end.release();
  }

  /** Resets mode, pull and the pin's end of the wire to the state after a start. */
  reset(): void {
    this.become('nothing');
    this.end.release();
    this.end.pull('none');
    this.currentMode = this.type.startMode;
    this.currentPull = DEFAULT_PULL;
    this.chosenPull = null;
  }

  /** Reads the wire's level, with the pin as an input and its pull on. */
  readDigital(): Level {
    this.take('read_digital');
    this.listen();
    return this.wire.level;
  }

  writeDigital(level: Level): void {
    this.take('write_digital');
    this.become('level');
    this.end.drive(level);
  }

  /** Reads the mean voltage, 0 … 1023 (rules A1, A2). The pin becomes an input without a pull. */
  readAnalog(): number {
    this.take('unused');
    this.become('nothing');
    this.end.release();
    const fraction = this.wire.isOpen ? OPEN_FRACTION : this.wire.fraction;
    return Math.min(ANALOG_MAX, Math.floor(fraction * (ANALOG_MAX + 1)));
  }

  /**
   * Puts a PWM signal on the wire. Zero is a steady low and leaves the pin `unused`, as on the device.
   *
   * @param value 0 … 1023; a RangeError is thrown beyond
   */
  writeAnalog(value: number): void {
    if (!(value >= 0 && value <= ANALOG_MAX)) throw new RangeError(`Analog value ${value} is not within 0 … 1023.`);
    this.take('write_analog');
    this.become('pwm');
    this.pwm.write(this.output, value);
    if (value === 0) this.currentMode = 'unused';
  }

  /**
   * Changes the PWM period of this and every other pin. A free pin that is not an analog output yet becomes one, at 0.
   *
   * @returns false, with nothing changed, for one that the hardware cannot do (the firmware does not hand this on)
   */
  setAnalogPeriodUs(periodUs: number): boolean {
    if (!this.pwm.setPeriodUs(periodUs)) return false;
    if (this.role !== 'pwm' && !HOLDING_MODES.has(this.currentMode)) {
      this.become('pwm');
      this.pwm.write(this.output, 0);
    }
    return true;
  }

  /** Chooses the resistor and makes the pin an input. */
  setPull(pull: Pull): void {
    this.take('read_digital');
    this.currentPull = pull;
    this.chosenPull = pull;
    this.listen();
    this.end.pull(pull);
  }

  /** Makes the pin sense a finger; resistive pads are held high by the board, a touch or a chip pulls them low. */
  senseTouch(kind: TouchKind): void {
    this.take('touch');
    this.become('touch');
    this.end.release();
    this.end.pull(kind === 'resistive' ? 'up' : 'none');
  }

  /** Puts a tone's square wave on the wire, or silence; does not touch a pin that something else holds (rule G7). */
  playTone(periodUs: number | null): void {
    if (this.currentMode !== 'music' && HOLDING_MODES.has(this.currentMode)) return;
    this.become('tone');
    if (periodUs === null) this.end.drive(0);
    else this.end.drivePwm({ periodUs, dutyFraction: TONE_DUTY });
  }

  /** Sends the bytes of an LED stream, low before and after. Needs no mode and changes none, as on the device. */
  sendStream(bytes: Uint8Array): void {
    this.become('level');
    this.end.drive(0);
    this.wire.stream(bytes);
  }

  /** Sends bytes of a serial line; the line rests high. Needs no mode and changes none, as on the device. */
  sendSerial(frame: SerialFrame): void {
    this.holdLevel(1);
    this.wire.serial(frame);
  }

  /** Drives a resting level for a bus that uses the pin. Needs no mode and changes none. */
  holdLevel(level: Level): void {
    this.become('level');
    this.end.drive(level);
  }

  /** Listens for a bus that uses the pin. Needs no mode and changes none. */
  holdInput(pull: Pull): void {
    this.become('bus');
    this.end.release();
    this.end.pull(pull);
  }

  private take(mode: PinMode): void {
    const holder = this.acquire(mode);
    if (holder) throw new Error(`${busyMessage(this, holder)}: ask acquire('${mode}') first.`);
  }

  private listen(): void {
    if (this.role === 'input') return;
    this.become('input');
    this.end.release();
    this.end.pull(this.currentPull);
  }

  /** Ends what the pin did before: its PWM channel and any pull. */
  private become(role: Role): void {
    if (role === this.role) return;
    if (this.role === 'pwm') this.pwm.drop(this.output);
    this.role = role;
    if (role !== 'input') this.end.pull('none');
  }
}

const ANALOG_MAX = 1023;
const OPEN_FRACTION = 0.5; // rule A2
const TONE_DUTY = 0.5; // chosen: the synthesiser's square wave is high half of the time

/** The device's ValueError for a held pin. */
export function busyMessage(pin: Pin, holder: PinMode): string {
  return `Pin ${pin.number} in ${holder} mode`;
}
