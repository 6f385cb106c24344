import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { nothingMeasured } from '#my-robot/my-robot';
import { answerFit } from './fit';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

describe('the worker that fits a robot', { timeout: 30_000 }, () => {
  it('answers with the traits, and with the drives before and after', async () => {
    const drives = { ...nothingMeasured.drives, usual: { aheadMm: 346, leftMm: -64 } };
    const measured = { ...nothingMeasured, drives };
    const answer = await answerFit({ type: 'fit', firmware, robot: 'maqueen-lite', measured });
    if (answer.type !== 'fitted') throw new Error(answer.message);
    const { traits, before, after } = answer.fit;
    expect(traits.motors.difference).toBeGreaterThan(0.03);
    expect(Math.abs(before.drives.usual.leftMm)).toBeLessThan(1);
    expect(after.drives.usual.leftMm).toBeCloseTo(-64, -1);
  });

  it('answers what is wrong instead of falling silent', async () => {
    expect(await answerFit({ type: 'fit', firmware, robot: 'k9', measured: nothingMeasured })).toEqual({
      type: 'failed',
      message: 'There is no robot "k9".',
    });
  });
});
