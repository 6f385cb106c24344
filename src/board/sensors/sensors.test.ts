import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '../boards/calliope-mini-3';
import { createBench } from '../testing/bench';

describe('the sensors', () => {
  it('R1: an unknown one is named', () => {
    const { sensors } = createBench().board;
    expect(() => sensors.get('lightlevel')).toThrow('There is no sensor "lightlevel"');
    expect(() => sensors.set('toString', 1)).toThrow(/no sensor "toString".*lightLevel/);
  });

  it('R2: a value out of range is named with its range, and nothing changes', () => {
    const { sensors } = createBench().board;
    expect(sensors.get('temperature')).toBe(21);
    expect(() => sensors.set('temperature', 80)).toThrow('Sensor temperature: 80 is not a number within -5 … 50 °C.');
    expect(() => sensors.set('lightLevel', '10')).toThrow('Sensor lightLevel: "10" is not a number within 0 … 255.');
    expect(() => sensors.set('gesture', 'jump')).toThrow('Sensor gesture: "jump" is none of none, up');
    expect(() => sensors.set('buttonA', 2)).toThrow(RangeError);
    expect([sensors.get('temperature'), sensors.get('lightLevel'), sensors.get('gesture')]).toEqual([21, 127, 'none']);
  });

  it('R2: what is within its range is kept', () => {
    const { sensors } = createBench().board;
    sensors.set('accelerometerX', -2000);
    sensors.set('gesture', 'face up');
    expect([sensors.get('accelerometerX'), sensors.get('gesture')]).toEqual([-2000, 'face up']);
  });

  it('R3: buttonA, pinLogo and pin0 press and release', () => {
    const { board } = createBench();
    board.sensors.set('buttonA', 1);
    board.sensors.set('pinLogo', 1);
    expect([board.buttonA.isDown, board.touch.get('pin_logo')?.isDown]).toEqual([true, true]);
    board.sensors.set('pinLogo', 0);
    expect(['buttonA', 'pinLogo', 'pin0'].map((id) => board.sensors.get(id))).toEqual([1, 0, 0]);
  });

  it('R5: all of them are described, with the ranges of now', () => {
    const { sensors } = createBench().board;
    sensors.limit('accelerometerX', -4000, 4000);
    const all = sensors.describe();
    expect(all.map(({ id }) => id)).toEqual(sensors.ids);
    const of = (id: string): unknown => all.find((info) => info.id === id);
    expect(of('accelerometerX')).toEqual({
      id: 'accelerometerX',
      kind: 'range',
      min: -4000,
      max: 4000,
      start: 0,
      unit: 'mg',
    });
    expect(of('pinLogo')).toEqual({ id: 'pinLogo', kind: 'range', min: 0, max: 1, start: 0, unit: '' });
    expect(of('gesture')).toMatchObject({ kind: 'choice', start: 'none', choices: expect.arrayContaining(['shake']) });
    expect(() => sensors.limit('buttonA', 0, 1)).toThrow('There is no sensor "buttonA"');
  });

  it('R5: the Calliope mini has a fourth pad', () => {
    const { sensors } = createBench(calliopeMini3).board;
    expect(sensors.describe().map(({ id }) => id)).toContain('pin3');
  });

  it('R4: a second shake is told like the first', () => {
    const { sensors } = createBench().board;
    const heard: string[] = [];
    const stop = sensors.onSet((id) => heard.push(`${id} ${sensors.get('gesture')}`));
    sensors.set('gesture', 'shake');
    sensors.set('gesture', 'shake');
    stop();
    sensors.set('gesture', 'none');
    expect(heard).toEqual(['gesture shake', 'gesture shake']);
  });

  it('a measured value is measured whenever it is asked for, without a word, until it is set', () => {
    const { sensors } = createBench().board;
    const heard: string[] = [];
    sensors.onSet((id) => heard.push(id));
    let level = 10;
    sensors.measure('lightLevel', () => level);
    expect(sensors.get('lightLevel')).toBe(10);
    level = 20;
    expect([sensors.get('lightLevel'), heard]).toEqual([20, []]);
    sensors.set('lightLevel', 30);
    expect([sensors.get('lightLevel'), heard]).toEqual([30, ['lightLevel']]);
  });
});
