import { describe, expect, it } from 'vitest';
import { defaultScene, type Zone } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';
import { verdictAtStart } from '#simulation/task/verdict-at-start';
import { zoneState } from './zone-state';

const zone = (type: Zone['type'], number = 0, blocks = 0): Zone => {
  return { type, id: `${type}${String(number)}`, at: [0, 0], size: [100, 100], angle: 0, round: false, number, blocks };
};
const open: Verdict = {
  ...verdictAtStart(defaultScene()),
  ...{ checkpoints: { passed: 0, of: 3 }, targets: { reached: 0, of: 1 }, blocks: { delivered: 0, of: 2 } },
};

describe('a zone of the course', () => {
  const checkpoints = [zone('checkpoint', 3), zone('checkpoint', 1), zone('checkpoint', 7)];

  it('is reached when it is among the first two checkpoints and two were passed, whatever their numbers', () => {
    const verdict = { ...open, checkpoints: { passed: 2, of: 3 } };
    expect(checkpoints.map((one) => zoneState(one, checkpoints, verdict))).toEqual(['reached', 'reached', 'open']);
  });

  it('is reached as a target for the robot when the robot has come to all of them', () => {
    const target = zone('target');
    expect(zoneState(target, [target], open)).toBe('open');
    expect(zoneState(target, [target], { ...open, targets: { reached: 1, of: 1 } })).toBe('reached');
  });

  it('is reached as a target for blocks when all of them have been delivered', () => {
    const target = zone('target', 0, 2);
    expect(zoneState(target, [target], { ...open, blocks: { delivered: 1, of: 2 } })).toBe('open');
    expect(zoneState(target, [target], { ...open, blocks: { delivered: 2, of: 2 } })).toBe('reached');
  });

  it('is open without a task, and never reached as a forbidden one', () => {
    expect(zoneState(zone('target'), [], null)).toBe('open');
    expect(zoneState(zone('forbidden'), [], { ...open, targets: { reached: 1, of: 1 } })).toBe('open');
  });
});
