import type { Feature } from '#core/board-api';
import type { Clock } from '#core/clock';
import type { Rgb } from '#core/rgb';
import type { BoardType, FirmwareType } from './boards/board-type';
import { Button } from './sensors/button';
import { Compass } from './sensors/compass';
import { DataLog } from './data-log';
import { Display } from './display/display';
import { I2cBus } from './wires/i2c-bus';
import { Microphone } from './sensors/microphone';
import { Motion } from './sensors/motion';
import { MotorOutputs, type MotorOutput } from './wires/motor-outputs';
import { MusicPlayer } from './sound/music-player';
import { Pin } from './wires/pin';
import { Power } from './power';
import { PwmUnit } from './wires/pwm-unit';
import { Radio } from './radio';
import { RgbLeds } from './display/rgb-leds';
import { SampledSensor } from './sensors/sampled-sensor';
import { padId, Sensors, type Pressable } from './sensors/sensors';
import { Sound } from './sound/sound';
import { SpiBus } from './wires/spi-bus';
import { TickGrid } from './tick-grid';
import { Touch } from './sensors/touch';
import { Uart } from './wires/uart';
import { Wire } from './wires/wire';

const SYSTEM_TICK_US = 4000; // codal-core: the scheduler's period, which samples buttons and touch pads
const TEMPERATURE_US = 1_000_000; // codal-nrf52 NRF52TemperatureSensor.h: one reading a second
const MACRO_TICK_US = 6000; // micropython-microbit-v2 main.cpp: display and music are served every 6 ms

/** A microcomputer board: its wires, pins, buses and what is soldered to it. It knows no program and no robot. */
export class Board {
  /** By name: the edge connector's `P0` … and the board's own, such as `logo` and `speaker`. */
  readonly wires: ReadonlyMap<string, Wire>;
  /** By Python name: `pin0`, `pin_logo`. */
  readonly pins: ReadonlyMap<string, Pin>;
  readonly i2c: I2cBus;
  readonly spi = new SpiBus();
  readonly uart = new Uart();
  readonly display: Display;
  readonly buttonA: Button;
  readonly buttonB: Button;
  /** By the Python name of their pin. */
  readonly touch: ReadonlyMap<string, Touch>;
  readonly music: MusicPlayer;
  readonly sound: Sound;
  readonly sensors: Sensors;
  readonly motion: Motion;
  readonly compass: Compass;
  readonly microphone: Microphone;
  /** The processor's temperature in degrees Celsius, whole or with the fraction that the sensor gives. */
  readonly thermometer: SampledSensor;
  readonly radio: Radio;
  readonly dataLog: DataLog;
  readonly power: Power;
  private readonly pwm = new PwmUnit();
  private readonly rgbLeds: RgbLeds | null;
  private readonly motorOutputs: MotorOutputs | null;

  /** @param firmware what the board runs; its type's default when left out */
  constructor(
    readonly type: BoardType,
    readonly clock: Clock,
    readonly firmware: FirmwareType = type.firmwares[0],
  ) {
    this.wires = new Map(type.pins.map((pin) => [pin.wire, new Wire(pin.wire)]));
    this.pins = new Map(type.pins.map((pin) => [pin.name, new Pin(pin, this.wire(pin.wire), this.pwm)]));
    this.i2c = new I2cBus(type.i2c.frequencyHz, { gapUs: type.costsUs.i2cGapUs, probeUs: type.costsUs.i2cProbeUs });
    const macroTicks = new TickGrid(clock, MACRO_TICK_US);
    const systemTicks = new TickGrid(clock, SYSTEM_TICK_US);
    this.display = new Display(
      macroTicks,
      type.displayPins.map((name) => this.pin(name)),
    );
    this.sound = new Sound(clock);
    this.music = new MusicPlayer(clock, macroTicks, this.sound);
    this.buttonA = new Button(this.pin(type.buttons.a).wire, systemTicks);
    this.buttonB = new Button(this.pin(type.buttons.b).wire, systemTicks);
    const pads = type.pins.filter((pin) => pin.touch !== null);
    this.touch = new Map(pads.map((pin) => [pin.name, new Touch(this.pin(pin.name), systemTicks)]));
    this.sensors = new Sensors(this.pressables());
    this.motion = new Motion(clock, this.sensors);
    this.compass = new Compass(this.sensors);
    this.microphone = new Microphone(clock, this.sensors, this.has('clap'));
    this.thermometer = new SampledSensor(clock, this.sensors, 'temperature', TEMPERATURE_US);
    this.radio = new Radio(clock);
    this.dataLog = new DataLog();
    this.power = new Power((isDark) => this.display.darken(isDark));
    this.rgbLeds = type.rgb && new RgbLeds(this.pin(type.rgb.pin).wire, type.rgb.count);
    this.motorOutputs = type.motors && this.createMotors(type.motors);
  }

  /** True if the firmware has a feature added after v2.1.2. */
  has(feature: Feature): boolean {
    return this.firmware.features.includes(feature);
  }

  /** The RGB LEDs soldered to the board; empty when there are none. */
  get rgb(): readonly Rgb[] {
    return this.rgbLeds?.colors ?? [];
  }

  /** The board's own motor connectors; empty when there are none. */
  get motors(): readonly MotorOutput[] {
    return this.motorOutputs?.outputs ?? [];
  }

  /**
   * Resets pins, buses, display and sound to their state after a start. What is outside stays: fingers, sensor values,
   * chips on the wires.
   */
  reset(): void {
    this.music.stop();
    this.music.resetTempo();
    this.sound.reset();
    for (const pin of this.pins.values()) pin.reset();
    this.pwm.reset();
    this.i2c.reset();
    this.spi.reset();
    this.uart.reset();
    this.display.reset();
    const { motion, compass, microphone, thermometer, radio, dataLog, power } = this;
    for (const part of [motion, compass, microphone, thermometer, radio, dataLog, power]) part.reset();
    for (const pad of this.touch.values()) pad.reset();
    this.buttonA.reset();
    this.buttonB.reset();
    this.rgbLeds?.reset();
  }

  /** The wire of this name. @throws RangeError if the board has no such wire */
  wire(name: string): Wire {
    const wire = this.wires.get(name);
    if (!wire)
      throw new RangeError(`${this.type.name} has no wire ${name}. It has ${[...this.wires.keys()].join(', ')}.`);
    return wire;
  }

  /** The pin of this Python name. @throws RangeError if the board has no such pin */
  pin(name: string): Pin {
    const pin = this.pins.get(name);
    if (!pin) throw new RangeError(`${this.type.name} has no pin ${name}. It has ${[...this.pins.keys()].join(', ')}.`);
    return pin;
  }

  private createMotors(motors: NonNullable<BoardType['motors']>): MotorOutputs {
    return new MotorOutputs(
      this.pin(motors.modePin).wire,
      motors.outputs.map(({ name, dirPin, speedPin }) => ({
        name,
        direction: this.pin(dirPin).wire,
        speed: this.pin(speedPin).wire,
      })),
    );
  }

  /** Sensor ids of everything that can be pressed: `buttonA`, `pin0`, and `pinLogo` for `pin_logo`. */
  private pressables(): ReadonlyMap<string, Pressable> {
    const pads = Array.from(this.touch, ([pin, pad]) => [padId(pin), pad] as const);
    return new Map<string, Pressable>([['buttonA', this.buttonA], ['buttonB', this.buttonB], ...pads]);
  }
}
