import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { Clock } from '#core/clock';
import { attachHcSr04, type HcSr04Options } from './hc-sr04';

/** A sensor facing something, and a log of the echo's edges in µs after the trigger fell. */
function sensorFacing(distanceMm: () => number, options?: HcSr04Options) {
  const clock = new Clock();
  const trigger = new Wire('P1');
  const echo = new Wire('P2');
  const stop = attachHcSr04(clock, { trigger, echo }, distanceMm, options);
  const board = trigger.connect('board');
  const edges: [number, number][] = [];
  echo.onLevel((level) => edges.push([clock.nowUs, level]));
  const pulse = (highUs: number): void => {
    board.drive(1);
    clock.advanceTo(clock.nowUs + highUs);
    board.drive(0);
  };
  return { clock, echo, edges, pulse, stop };
}

describe('HC-SR04', () => {
  it('answers for 582 µs when something stands 10 cm away', () => {
    const { clock, edges, pulse } = sensorFacing(() => 100);
    pulse(10);
    clock.advanceTo(100_000);
    expect(edges).toEqual([
      [10 + 450, 1],
      [10 + 450 + 582, 0],
    ]);
  });

  it.each([
    [50, 291],
    [1000, 5820],
    [2000, 11_640],
    [4500, 26_190],
  ])('turns %i mm into an echo of %i µs', (distanceMm, expectedUs) => {
    const { clock, edges, pulse } = sensorFacing(() => distanceMm);
    pulse(10);
    clock.advanceTo(100_000);
    expect((edges[1]?.[0] ?? 0) - (edges[0]?.[0] ?? 0)).toBe(expectedUs);
  });

  it('is triggered by a pulse of 0 µs, as two write_digital calls without a pause make it', () => {
    const { clock, edges, pulse } = sensorFacing(() => 100);
    pulse(0);
    clock.advanceTo(10_000);
    expect(edges).toHaveLength(2);
  });

  it('waits for the falling edge: a trigger that stays high for 20 ms starts nothing before', () => {
    const { clock, edges, pulse } = sensorFacing(() => 100);
    pulse(20_000);
    expect(edges).toEqual([]);
    clock.advanceTo(30_000);
    expect(edges[0]).toEqual([20_450, 1]);
  });

  it('keeps the echo low between measurements', () => {
    const { echo } = sensorFacing(() => 100);
    expect(echo.level).toBe(0);
  });

  it('asks for the distance at the moment of the trigger', () => {
    let distanceMm = 100;
    const { clock, edges, pulse } = sensorFacing(() => distanceMm);
    pulse(10);
    distanceMm = 4000;
    clock.advanceTo(50_000);
    expect(edges[1]?.[0]).toBe(10 + 450 + 582);
  });

  it('stays silent when nothing is in range', () => {
    const { clock, edges, pulse } = sensorFacing(() => Infinity);
    pulse(10);
    clock.advanceTo(100_000);
    expect(edges).toEqual([]);
  });

  it('has a range of 450 cm: 4501 mm is out of it', () => {
    const { clock, edges, pulse } = sensorFacing(() => 4501);
    pulse(10);
    clock.advanceTo(100_000);
    expect(edges).toEqual([]);
  });

  it('can give the classic 38 ms pulse when nothing is in range', () => {
    const { clock, edges, pulse } = sensorFacing(() => Infinity, { withoutTarget: 'long-pulse' });
    pulse(10);
    clock.advanceTo(100_000);
    expect(edges).toEqual([
      [460, 1],
      [38_460, 0],
    ]);
  });

  it('reads 2 cm for anything nearer', () => {
    const { clock, edges, pulse } = sensorFacing(() => 3);
    pulse(10);
    clock.advanceTo(10_000);
    expect((edges[1]?.[0] ?? 0) - (edges[0]?.[0] ?? 0)).toBe(116);
  });

  it('ignores a trigger while an echo is on its way', () => {
    const { clock, edges, pulse } = sensorFacing(() => 1000);
    pulse(10);
    clock.advanceTo(2000);
    pulse(10);
    clock.advanceTo(100_000);
    expect(edges).toHaveLength(2);
  });

  it('measures again once the echo has ended', () => {
    const { clock, edges, pulse } = sensorFacing(() => 100);
    pulse(10);
    clock.advanceTo(5000);
    pulse(10);
    clock.advanceTo(10_000);
    expect(edges).toHaveLength(4);
  });

  it('lets go of both wires when detached, even in the middle of an echo', () => {
    const { clock, echo, edges, pulse, stop } = sensorFacing(() => 1000);
    pulse(10);
    clock.advanceTo(1000);
    stop();
    expect(echo.level).toBe(0);
    pulse(10);
    clock.advanceTo(100_000);
    expect(edges).toHaveLength(2);
  });
});

describe('HC-SR04 with trigger and echo on one wire', () => {
  /** The sensor, the board's end of the wire, and a log of the wire's edges in µs. */
  function onOneWire(distanceMm: number) {
    const clock = new Clock();
    const wire = new Wire('P15');
    attachHcSr04(clock, { trigger: wire, echo: wire }, () => distanceMm);
    const edges: [number, number][] = [];
    wire.onLevel((level) => edges.push([clock.nowUs, level]));
    const board = wire.connect('board');
    const trigger = (): void => {
      board.drive(1);
      clock.advanceTo(clock.nowUs + 10);
      board.drive(0);
    };
    return { clock, wire, board, edges, trigger };
  }

  it('answers on it for 582 µs when the board has let go and something stands 10 cm away', () => {
    const { clock, board, edges, trigger } = onOneWire(100);
    trigger();
    board.release();
    clock.advanceTo(100_000);
    expect(edges).toEqual([[0, 1], [10, 0], [460, 1], [1042, 0]]); // prettier-ignore
  });

  it('does not take the end of its own echo for a trigger, and measures again at the next one', () => {
    const { clock, board, edges, trigger } = onOneWire(100);
    trigger();
    board.release();
    clock.advanceTo(100_000);
    trigger();
    board.release();
    clock.advanceTo(200_000);
    expect(edges).toHaveLength(8);
    expect(edges.at(-1)).toEqual([101_042, 0]);
  });

  it('is not heard by a board that goes on driving low', () => {
    const { clock, edges, trigger } = onOneWire(100);
    trigger();
    clock.advanceTo(100_000);
    expect(edges).toEqual([[0, 1], [10, 0]]); // prettier-ignore
  });

  it('leaves the wire to the others between measurements: a pull-up makes it high', () => {
    const { wire, board } = onOneWire(100);
    board.pull('up');
    expect(wire.level).toBe(1);
  });
});
