import { describe, expect, it } from 'vitest';
import { createBench } from './testing/bench';

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
});
