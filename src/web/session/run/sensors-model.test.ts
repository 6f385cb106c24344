import { describe, expect, it } from 'vitest';

import type { InputAction } from '#simulation/input';
import { SensorsModel } from './sensors-model';

function model() {
  const sent: InputAction[] = [];
  return { sensors: new SensorsModel({ input: (action) => sent.push(action) > 0, device: 0 }), sent };
}

describe('sensors set by hand', () => {
  it('reach the run at once and every further run at its start', () => {
    const { sensors, sent } = model();
    sensors.set('lightLevel', 10);
    sensors.set('lightLevel', 200);
    sensors.set('temperature', -3);
    expect(sent).toEqual([
      { type: 'sensor', id: 'lightLevel', value: 10 },
      { type: 'sensor', id: 'lightLevel', value: 200 },
      { type: 'sensor', id: 'temperature', value: -3 },
    ]);
    expect(sensors.startInputs()).toEqual([
      { timeUs: 0, action: { type: 'sensor', id: 'lightLevel', value: 200 } },
      { timeUs: 0, action: { type: 'sensor', id: 'temperature', value: -3 } },
    ]);
  });

  it('fire a gesture once for every press, and never at the start of a run', () => {
    const { sensors, sent } = model();
    sensors.gesture('shake');
    sensors.gesture('shake');
    expect(sent).toHaveLength(2);
    expect(sensors.startInputs()).toEqual([]);
  });

  it('go back to what the board feels at its start, only those that were set', () => {
    const { sensors, sent } = model();
    sensors.set('lightLevel', 10);
    sent.length = 0;
    sensors.reset(new Map([['lightLevel', 127], ['temperature', 21]])); // prettier-ignore
    expect(sent).toEqual([{ type: 'sensor', id: 'lightLevel', value: 127 }]);
    expect(sensors.startInputs()).toEqual([]);
  });
});
