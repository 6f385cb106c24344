import type { Clock } from '#core/clock';
import type { BoardType } from './board-type';
import { Button } from './button';
import { Display } from './display';
import { I2cBus } from './i2c-bus';
import { MusicPlayer } from './music-player';
import { Pin } from './pin';
import { PwmUnit } from './pwm-unit';
import { Sensors, type Pressable } from './sensors';
import { TickGrid } from './tick-grid';
import { Touch } from './touch';
import { Wire } from './wire';

const SYSTEM_TICK_US = 4000; // codal-core: the scheduler's period, which samples buttons and touch pads
const MACRO_TICK_US = 6000; // micropython-microbit-v2 main.cpp: display and music are served every 6 ms

/** A microcomputer board: its wires, pins, buses and what is soldered to it. It knows no program and no robot. */
export class Board {
  /** By name: the edge connector's `P0` … and the board's own, such as `logo` and `speaker`. */
  readonly wires: ReadonlyMap<string, Wire>;
  /** By Python name: `pin0`, `pin_logo`. */
  readonly pins: ReadonlyMap<string, Pin>;
  readonly i2c: I2cBus;
  readonly display: Display;
  readonly buttonA: Button;
  readonly buttonB: Button;
  /** By the Python name of their pin. */
  readonly touch: ReadonlyMap<string, Touch>;
  readonly music: MusicPlayer;
  readonly sensors: Sensors;

  constructor(
    readonly type: BoardType,
    readonly clock: Clock,
  ) {
    const pwm = new PwmUnit();
    this.wires = new Map(type.pins.map((pin) => [pin.wire, new Wire(pin.wire)]));
    this.pins = new Map(type.pins.map((pin) => [pin.name, new Pin(pin, this.wire(pin.wire), pwm)]));
    this.i2c = new I2cBus(type.i2c.frequencyHz, { gapUs: type.costsUs.i2cGapUs, probeUs: type.costsUs.i2cProbeUs });
    const macroTicks = new TickGrid(clock, MACRO_TICK_US);
    const systemTicks = new TickGrid(clock, SYSTEM_TICK_US);
    this.display = new Display(
      macroTicks,
      type.displayPins.map((name) => this.pin(name)),
    );
    this.music = new MusicPlayer(clock, macroTicks);
    this.buttonA = new Button(this.pin(type.buttons.a).wire, systemTicks);
    this.buttonB = new Button(this.pin(type.buttons.b).wire, systemTicks);
    const pads = type.pins.filter((pin) => pin.touch !== null);
    this.touch = new Map(pads.map((pin) => [pin.name, new Touch(this.pin(pin.name), systemTicks)]));
    this.sensors = new Sensors(this.pressables());
  }

  /** The wire of this name. @throws RangeError when the board has none */
  wire(name: string): Wire {
    const wire = this.wires.get(name);
    if (!wire)
      throw new RangeError(`${this.type.name} has no wire ${name}. It has ${[...this.wires.keys()].join(', ')}.`);
    return wire;
  }

  /** The pin of this Python name. @throws RangeError when the board has none */
  pin(name: string): Pin {
    const pin = this.pins.get(name);
    if (!pin) throw new RangeError(`${this.type.name} has no pin ${name}. It has ${[...this.pins.keys()].join(', ')}.`);
    return pin;
  }

  /** Sensor ids of what can be pressed: `buttonA`, `pin0`, and `pinLogo` for `pin_logo`. */
  private pressables(): ReadonlyMap<string, Pressable> {
    const all = new Map<string, Pressable>([
      ['buttonA', this.buttonA],
      ['buttonB', this.buttonB],
    ]);
    for (const [name, pad] of this.touch) {
      all.set(
        name.replace(/_(.)/, (_, letter: string) => letter.toUpperCase()),
        pad,
      );
    }
    return all;
  }
}
