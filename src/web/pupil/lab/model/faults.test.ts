import { describe, expect, it } from 'vitest';

import { defaultScene } from '#scene/scene';
import { faultsOf } from '#simulation/reality';
import { soloRun } from '#simulation/run-setup';
import { faultsIn } from './faults';

const setupOf = (seed: number, reality = 1) =>
  soloRun({ scene: defaultScene(), files: {}, robot: 'maqueen-lite', board: 'microbit-v2', seed, reality });
const drive = { way: [], endUs: 0, lineMm: [{ x: 40, y: 8 }, { x: 40, y: -8 }] }; // prettier-ignore

describe('what is different about a used robot', () => {
  it.each(Array.from({ length: 50 }, (_, at) => at + 1))('is what chance has drawn for it: Nr. %i', (seed) => {
    const { motors, lighter } = faultsOf(1, seed);
    const faults = faultsIn({ setup: setupOf(seed), drive });
    expect(faults[0]).toEqual({
      ...{ kind: 'pulls', to: motors.difference > 0 ? 'right' : 'left' },
      isHard: Math.abs(motors.difference) > 0.045,
    });
    const weaker = faults.find((one) => one.kind === 'weaker');
    const percent = Math.round(100 * (1 - motors.charge));
    expect(weaker?.percent ?? 0).toBe(percent < 2 ? 0 : percent);
    const [left, right] = drive.lineMm.map(lighter);
    const sees = faults.find((one) => one.kind === 'sees');
    const most = Math.max(Math.abs(left ?? 0), Math.abs(right ?? 0));
    expect(sees !== undefined).toBe(most >= 0.04);
    if (sees !== undefined) {
      const by = (sees.side === 'left' ? left : right) ?? 0;
      expect([Math.abs(by), by > 0]).toEqual([most, sees.isLighter]);
    }
  });

  it('is nothing for a new one, and chance alone for one that was measured', () => {
    expect(faultsIn({ setup: setupOf(3, 0), drive })).toEqual([]);
    const setup = setupOf(3);
    const [first] = setup.devices;
    const traits = { motors: faultsOf(1, 1).motors } as NonNullable<typeof first.traits>;
    expect(faultsIn({ setup: { ...setup, devices: [{ ...first, traits }] }, drive })).toEqual([{ kind: 'trembles' }]);
  });
});
