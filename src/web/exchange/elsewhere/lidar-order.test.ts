import { describe, expect, it } from 'vitest';

import { inEvery } from '#core/words';
import type { Option } from '#core/option';
import type { Hardware } from '#simulation/hardware';
import { asksForFields, otherOrder } from './lidar-order';

const choice = (id: string) => ({ id, title: inEvery(() => id) });
const lidarOrder: Option = {
  ...{ id: 'lidarOrder', title: inEvery(() => 'Order') },
  choices: ['maker', 'transposed'].map(choice),
};
/** The hardware with a robot that has these options, set like this. */
const hardware = (options: readonly Option[], values: Hardware['options']): Hardware =>
  ({ robot: { options }, options: values }) as Hardware;

describe('the order of a lidar’s fields', () => {
  it.each([
    ['print(getDistanceAt(3, 3))', true],
    ['if True:\n    x = robot.getDistanceGrid ()', true],
    ['getDistanceRow(2)', true],
    ['getDistanceColumn(2)', true],
    ['getDistance()\ngetDistanceList()', false],
    ['# getDistanceAt(3, 3)', false],
    ['forgetDistanceAt(3)', false],
  ])('matters in %s: %s', (text, matters) => expect(asksForFields([{ name: 'main.py', text }])).toBe(matters));

  it('can be turned where the robot has an option for it that is not chosen yet', () => {
    expect(otherOrder(hardware([lidarOrder], { lidarOrder: 'maker' }))).toMatchObject({ choice: { de: 'transposed' } });
    expect(otherOrder(hardware([lidarOrder], { lidarOrder: 'transposed' }))).toBeNull();
    expect(otherOrder(hardware([], {}))).toBeNull();
    expect(otherOrder({ ...hardware([], {}), robot: null })).toBeNull();
  });
});
