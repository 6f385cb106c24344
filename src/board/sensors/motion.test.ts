import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '../boards/calliope-mini-3';
import { microbitV2 } from '../boards/microbit-v2';
import type { Bench } from '../testing/bench';
import { createBench } from '../testing/bench';

function set(bench: Bench, x: number, y: number, z: number): void {
  for (const [axis, mg] of Object.entries({ X: x, Y: y, Z: z })) bench.board.sensors.set(`accelerometer${axis}`, mg);
}

/** A board at rest, its display up, for a second. */
function lying(): Bench {
  const bench = createBench();
  set(bench, 0, 0, -1024);
  bench.passMs(1000);
  bench.board.motion.takeGestures();
  return bench;
}

describe('accelerometer', () => {
  it('K1: looks every 20 ms: what comes at 21 ms is there at 40 ms', () => {
    const bench = createBench();
    bench.passMs(21);
    bench.board.sensors.set('accelerometerX', 700);
    bench.passMs(18.999);
    expect(bench.board.motion.acceleration.x).toBe(0);
    bench.passUs(1);
    expect(bench.board.motion.acceleration.x).toBe(700);
  });

  it('K1: what comes in the very µs of a look waits for the next one', () => {
    const bench = createBench();
    bench.passMs(40);
    bench.board.sensors.set('accelerometerY', 5);
    expect(bench.board.motion.acceleration.y).toBe(0);
    bench.passMs(20);
    expect(bench.board.motion.acceleration.y).toBe(5);
  });

  it('K1: comes out the same whether somebody asks in between or not', () => {
    const gestures = [true, false].map((asks) => {
      const bench = createBench();
      for (let ms = 0; ms < 3000; ms += 10) {
        bench.passMs(10);
        if (ms % 90 === 0) set(bench, ms % 180 === 0 ? 1500 : -1500, (ms % 700) - 300, -1000 + ms);
        if (asks) expect(bench.board.motion.acceleration.z).toBeLessThan(2001);
      }
      return bench.board.motion.takeGestures();
    });
    expect(gestures[0]).toEqual(gestures[1]);
    expect(gestures[0]?.length).toBeGreaterThan(3);
  });

  it('K2: gives whole mg, cut off, and the strength of all three', () => {
    const bench = createBench();
    set(bench, 300.9, -400.9, 0);
    bench.passMs(20);
    expect(bench.board.motion.acceleration).toEqual({ x: 300, y: -400, z: 0 });
    expect(bench.board.motion.strength).toBe(500);
  });

  it('K3: reaches 2 g; 3 makes it 4 g and 5 makes it 8 g, and what is beyond comes within', () => {
    const { board } = createBench();
    const reach = (): unknown => board.sensors.describe().find(({ id }) => id === 'accelerometerZ');
    expect(reach()).toMatchObject({ min: -2000, max: 2000, unit: 'mg', start: -1024 });
    board.motion.setRange(3);
    expect(reach()).toMatchObject({ min: -4000, max: 4000 });
    board.motion.setRange(5);
    board.sensors.set('accelerometerZ', -7500);
    board.motion.setRange(100);
    expect(reach()).toMatchObject({ min: -8000, max: 8000 });
    board.motion.setRange(1);
    expect(board.sensors.get('accelerometerZ')).toBe(-2000);
    expect(() => board.sensors.set('accelerometerZ', -2001)).toThrow('within -2000 … 2000 mg');
  });

  it('K4: a posture beyond 800 mg is a gesture once it has lasted six samples', () => {
    const bench = lying();
    set(bench, 801, 0, -500);
    while (bench.board.motion.gesture !== 'right') bench.passMs(1);
    expect(bench.nowMs).toBe(1120);
    expect(bench.board.motion.takeGestures()).toEqual(['right']);
  });

  it.each([
    ['left', -900, 0, 0],
    ['right', 900, 0, 0],
    ['down', 0, -900, 0],
    ['up', 0, 900, 0],
    ['face up', 0, 0, -900],
    ['face down', 0, 0, 900],
    ['freefall', 100, 100, 100],
    ['', 600, 0, -600],
  ])('K4: %s', (gesture, x, y, z) => {
    const bench = lying();
    set(bench, x, y, z);
    bench.passMs(200);
    expect(bench.board.motion.gesture).toBe(gesture);
  });

  it.each([microbitV2, calliopeMini3])(
    'K5: a board at rest feels gravity from the start, and lies face up: $id',
    (type) => {
      const { board, passMs } = createBench(type);
      expect([board.motion.acceleration, board.motion.gesture]).toEqual([{ x: 0, y: 0, z: -1024 }, 'face up']);
      expect(board.motion.takeGestures()).toEqual(['face up']);
      passMs(1000);
      expect([board.motion.strength, board.motion.gesture]).toEqual([1024, 'face up']);
      expect(board.motion.takeGestures()).toEqual([]);
      board.sensors.set('accelerometerZ', 0);
      passMs(1000);
      expect(board.motion.gesture).toBe('freefall');
    },
  );

  it('K5: how it is set before the start is how it lies there', () => {
    const bench = createBench();
    set(bench, 900, 0, -300);
    expect([bench.board.motion.acceleration.x, bench.board.motion.gesture]).toEqual([900, 'right']);
    expect(bench.board.motion.takeGestures()).toEqual(['right']);
  });

  it('K6: four swings beyond 400 mg in quick succession are a shake', () => {
    const bench = lying();
    for (const x of [900, -900, 900, -900]) {
      set(bench, x, 0, 300);
      bench.passMs(40);
    }
    expect(bench.board.motion.takeGestures()).toContain('shake');
  });

  it('K6: slow swings are none', () => {
    const bench = lying();
    for (const x of [500, -500, 500, -500, 500, -500]) {
      set(bench, x, 0, -700);
      bench.passMs(400);
    }
    expect(bench.board.motion.takeGestures()).not.toContain('shake');
  });

  it('K7: a blow of 6.5 g is 2g, 3g and 6g, once until it has subsided', () => {
    const bench = lying();
    bench.board.motion.setRange(8);
    set(bench, 0, 0, -6500);
    bench.passMs(300);
    expect(bench.board.motion.takeGestures()).toEqual(['2g', '3g', '6g']);
    set(bench, 0, 0, -1024);
    bench.passMs(200);
    set(bench, 0, 0, -2100);
    bench.passMs(20);
    expect(bench.board.motion.takeGestures()).toEqual(['2g']);
  });

  it('K8: a gesture set from outside is one each time, and stays until another one comes', () => {
    const bench = lying();
    bench.board.sensors.set('gesture', 'shake');
    bench.board.sensors.set('gesture', 'shake');
    bench.passMs(500);
    expect(bench.board.motion.gesture).toBe('shake');
    expect(bench.board.motion.takeGestures()).toEqual(['shake', 'shake']);
    bench.board.sensors.set('gesture', 'none');
    expect(bench.board.motion.gesture).toBe('face up');
    expect(bench.board.motion.takeGestures()).toEqual([]);
  });

  it('K9: wasGesture forgets its own gesture and the list; the list keeps the first 16', () => {
    const { board } = lying();
    for (let i = 0; i < 20; i++) board.sensors.set('gesture', i < 16 ? 'up' : 'down');
    expect(board.motion.takeGestures()).toEqual(Array.from({ length: 16 }, () => 'up'));
    board.sensors.set('gesture', 'left');
    expect([board.motion.wasGesture('up'), board.motion.wasGesture('up')]).toEqual([true, false]);
    expect(board.motion.takeGestures()).toEqual([]);
    expect(board.motion.wasGesture('left')).toBe(true);
  });

  it('K10: a reset forgets range and gestures but for the posture; what the sensors feel stays', () => {
    const { board, passMs } = lying();
    board.motion.setRange(8);
    board.sensors.set('gesture', 'shake');
    board.reset();
    expect([board.motion.gesture, board.motion.wasGesture('shake')]).toEqual(['face up', false]);
    passMs(20);
    expect(board.motion.acceleration.z).toBe(-1024);
    expect(() => board.sensors.set('accelerometerX', 3000)).toThrow(RangeError);
  });
});

describe('compass', () => {
  it('K11: gives whole degrees 0 … 359 and whole nT', () => {
    const { board } = createBench();
    board.sensors.set('compassHeading', 271.9);
    expect(board.compass.heading()).toBe(271);
    board.sensors.set('compassHeading', 360);
    expect(board.compass.heading()).toBe(0);
    board.sensors.set('compassX', -30_000);
    board.sensors.set('compassY', 40_000.5);
    expect(board.compass.field).toEqual({ x: -30_000, y: 40_000, z: 0 });
    expect(board.compass.fieldStrength).toBe(50_000);
  });

  it('K12: is calibrated at the start; once cleared, asking for the heading calibrates it', () => {
    const { compass } = createBench().board;
    expect(compass.isCalibrated).toBe(true);
    compass.clearCalibration();
    expect(compass.isCalibrated).toBe(false);
    compass.heading();
    expect(compass.isCalibrated).toBe(true);
  });
});

describe('thermometer', () => {
  it('K13: the first question reads it, then it is read once a second', () => {
    const { board, passMs } = createBench();
    passMs(300);
    board.sensors.set('temperature', 25);
    passMs(200);
    expect(board.thermometer.value).toBe(25); // from 500 ms on, every second
    passMs(10);
    board.sensors.set('temperature', 30);
    passMs(980);
    board.sensors.set('temperature', 31);
    passMs(9.999);
    expect(board.thermometer.value).toBe(25);
    passMs(0.001);
    expect(board.thermometer.value).toBe(31);
    passMs(5000);
    board.sensors.set('temperature', 10);
    expect(board.thermometer.value).toBe(31);
  });
});
