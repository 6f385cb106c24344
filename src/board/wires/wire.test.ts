import { describe, expect, it } from 'vitest';
import { createBench } from '../testing/bench';
import { Wire, type Level } from './wire';

/** A wire with two chips on it. */
function twoChips() {
  const wire = new Wire('P8');
  return { wire, one: wire.connect('one'), two: wire.connect('two') };
}

describe('a wire', () => {
  it('W1: a level that is driven can be read at once', () => {
    const { wire, one } = twoChips();
    one.drive(1);
    expect(wire.level).toBe(1);
    one.drive(0);
    expect(wire.level).toBe(0);
  });

  it('W2: low wins when one chip drives high and another low, whoever came first', () => {
    const { wire, one, two } = twoChips();
    one.drive(1);
    two.drive(0);
    expect(wire.level).toBe(0);
    one.drive(0);
    two.drive(1);
    expect(wire.level).toBe(0);
  });

  it('W2: low wins over a PWM signal too, which is then no longer there', () => {
    const { wire, one, two } = twoChips();
    one.drivePwm({ periodUs: 20_000, dutyFraction: 0.9 });
    two.drive(0);
    expect(wire.level).toBe(0);
    expect(wire.pwm).toBeNull();
    expect(wire.fraction).toBe(0);
  });

  it('W3: a chip that drives low wins over a pull up, one that drives high over a pull down', () => {
    const { wire, one, two } = twoChips();
    one.pull('up');
    two.drive(0);
    expect(wire.level).toBe(0);
    one.pull('down');
    two.drive(1);
    expect(wire.level).toBe(1);
  });

  it('W3: of two voltages the one of the end connected first counts', () => {
    const { wire, one, two } = twoChips();
    two.driveAnalog(0.9);
    one.driveAnalog(0.4);
    expect(wire.fraction).toBe(0.4);
  });

  it('W4: when a chip releases or leaves, the other one decides', () => {
    const { wire, one, two } = twoChips();
    one.drive(0);
    two.drive(1);
    one.release();
    expect(wire.level).toBe(1);
    two.detach();
    expect(wire.level).toBe(0);
    two.drive(1);
    expect(wire.level).toBe(0);
  });

  it('W5: up wins when one end pulls up and another down', () => {
    const { wire, one, two } = twoChips();
    one.pull('down');
    two.pull('up');
    expect(wire.level).toBe(1);
  });

  it('W6: a wire that nobody drives or pulls reads 0', () => {
    const { wire, one } = twoChips();
    one.drive(1);
    one.release();
    expect(wire.level).toBe(0);
    expect(wire.fraction).toBe(0);
  });

  it('W7: a voltage reads 1 from 70 %, 0 up to 30 %, and in between what it read before', () => {
    const { wire, one } = twoChips();
    const readings = [0.5, 0.7, 0.5, 0.31, 0.3, 0.5, 1].map((fraction) => {
      one.driveAnalog(fraction);
      return wire.level;
    });
    expect(readings).toEqual([0, 1, 1, 1, 0, 0, 1]);
  });

  it('W7: a voltage beyond the supply counts as the supply', () => {
    const { wire, one } = twoChips();
    one.driveAnalog(1.4);
    expect(wire.fraction).toBe(1);
    one.driveAnalog(-1);
    expect(wire.fraction).toBe(0);
  });

  it('W8: a change is told once, and a level that stays is not told', () => {
    const { wire, one, two } = twoChips();
    const heard: string[] = [];
    wire.onLevel((level) => heard.push(`first ${level}`));
    wire.onLevel((level) => heard.push(`second ${level}`));
    one.drive(1);
    one.drive(1);
    two.drive(1);
    one.drive(0);
    expect(heard).toEqual(['first 1', 'second 1', 'first 0', 'second 0']);
  });

  it('W8: a PWM signal is told when it starts, changes and ends', () => {
    const { wire, one } = twoChips();
    const heard: (number | null)[] = [];
    wire.onPwm((pwm) => heard.push(pwm?.dutyFraction ?? null));
    one.drivePwm({ periodUs: 20_000, dutyFraction: 0.2 });
    one.drivePwm({ periodUs: 20_000, dutyFraction: 0.4 });
    one.drive(1);
    expect(heard).toEqual([0.2, 0.4, null]);
  });

  it('W9: when a listener answers a change, everyone still hears the change before the answer', () => {
    const { wire, one, two } = twoChips();
    const heard: Level[] = [];
    wire.onLevel((level) => {
      if (level === 1) two.drive(0);
    });
    wire.onLevel((level) => heard.push(level));
    one.drive(1);
    expect(heard).toEqual([1, 0]);
    expect(wire.level).toBe(0);
  });

  it('W10: a listener that another one stops does not hear the change any more', () => {
    const { wire, one } = twoChips();
    const heard: Level[] = [];
    wire.onLevel(() => stopSecond());
    const stopSecond = wire.onLevel((level) => heard.push(level));
    one.drive(1);
    expect(heard).toEqual([]);
  });

  it('W10: stopping twice leaves a second subscription of the same listener alone', () => {
    const { wire, one } = twoChips();
    const heard: Level[] = [];
    const listener = (level: Level): void => void heard.push(level);
    const stop = wire.onLevel(listener);
    wire.onLevel(listener);
    stop();
    stop();
    one.drive(1);
    expect(heard).toEqual([1]);
  });

  it('W11: asking for a wire that is not there names it', () => {
    const { board } = createBench();
    expect(board.wire('P16').name).toBe('P16');
    expect(() => board.wire('P17')).toThrow(/micro:bit V2 has no wire P17.*P16/);
    expect(() => board.pin('pin17')).toThrow(/no pin pin17/);
  });
});

describe('an end that says late what it drives', () => {
  /** A chip that may be asked by now; its level at each moment, and how often it was asked. */
  function lateChip() {
    const chips = twoChips();
    const chip = { now: 1 as Level, asked: 0 };
    const level = (): Level => {
      chip.asked++;
      return chip.now;
    };
    return { ...chips, chip, tell: () => chips.one.driveLate(level) };
  }

  it('W12: is asked once when the wire is read, and not before', () => {
    const { wire, chip, tell } = lateChip();
    tell();
    tell();
    expect(chip.asked).toBe(0);
    expect([wire.level, wire.level, wire.fraction, chip.asked]).toEqual([1, 1, 1, 1]);
    chip.now = 0;
    expect(wire.level).toBe(1);
    tell();
    expect([wire.level, chip.asked]).toEqual([0, 2]);
  });

  it.each<[string, (wire: Wire) => unknown]>([
    ['its PWM signal', (wire) => wire.pwm],
    ['its voltage', (wire) => wire.fraction],
    ['whether it is open', (wire) => wire.isOpen],
  ])('W12: is asked when somebody asks the wire for %s', (_, ask) => {
    const { wire, chip, tell } = lateChip();
    tell();
    ask(wire);
    expect(chip.asked).toBe(1);
  });

  it('W12: is asked at once while somebody listens, also when that begins later', () => {
    const { wire, chip, tell } = lateChip();
    tell();
    const heard: Level[] = [];
    const stop = wire.onLevel((level) => heard.push(level));
    expect([heard, chip.asked]).toEqual([[], 1]);
    chip.now = 0;
    tell();
    tell();
    expect([heard, chip.asked]).toEqual([[0], 3]);
    stop();
    tell();
    expect(chip.asked).toBe(3);
  });

  it.each<[string, (chips: ReturnType<typeof twoChips>) => void]>([
    ['drives', ({ two }) => two.drive(1)],
    ['pulls', ({ two }) => two.pull('down')],
    ['leaves', ({ two }) => two.detach()],
    ['says late what it drives, too', ({ two }) => two.driveLate(() => 1)],
  ])('W12: is asked before another end %s', (_, change) => {
    const { chip, tell, ...chips } = lateChip();
    tell();
    change(chips);
    expect(chip.asked).toBe(1);
  });

  it('W12: counts as it was before it drives at once, releases or leaves', () => {
    const { wire, one, chip, tell } = lateChip();
    tell();
    one.drive(1);
    chip.now = 0;
    expect(wire.level).toBe(1);
    tell();
    one.release();
    expect([wire.level, chip.asked]).toEqual([0, 2]);
    tell();
    one.detach();
    chip.now = 1;
    expect([wire.level, chip.asked]).toEqual([0, 3]);
  });
});

describe('an LED stream', () => {
  it('S1: arrives byte by byte at everyone who listens on the wire', () => {
    const { board } = createBench();
    const heard: number[][] = [];
    board.wire('P15').onStream((bytes) => heard.push([...bytes]));
    board.wire('P15').onStream((bytes) => heard.push([...bytes]));
    board.pin('pin15').sendStream(Uint8Array.of(0, 20, 0, 255, 1, 2));
    expect(heard).toEqual([
      [0, 20, 0, 255, 1, 2],
      [0, 20, 0, 255, 1, 2],
    ]);
  });

  it('S2: leaves the wire low and makes no level changes of its own', () => {
    const { board, record } = createBench();
    const pin = board.pin('pin15');
    pin.writeDigital(1);
    const happened = record('P15');
    pin.sendStream(Uint8Array.of(255, 255, 255));
    expect(happened).toEqual(['0 ms: 0']);
    expect(board.wire('P15').level).toBe(0);
  });

  it('S3: needs no mode, and the pin is an input again when it is read', () => {
    const { board, chip } = createBench();
    const pin = board.pin('pin15');
    chip('P15').drive(1);
    expect(pin.readDigital()).toBe(1);
    pin.sendStream(Uint8Array.of(1));
    expect(pin.mode).toBe('read_digital');
    expect(pin.readDigital()).toBe(1);
  });

  it('S4: is awaited by 2 listeners, by 1 when one of them has gone', () => {
    const wire = new Wire('P15');
    expect(wire.streamListenerCount).toBe(0);
    wire.onStream(() => undefined);
    const stop = wire.onStream(() => undefined);
    expect(wire.streamListenerCount).toBe(2);
    stop();
    stop();
    expect(wire.streamListenerCount).toBe(1);
  });
});
