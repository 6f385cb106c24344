import { describe, expect, it } from 'vitest';

import { defaultProjectSettings } from '#project/project';

import { defaultSettings } from './settings';
import { travelling, withTravelling } from './travelling';

describe('the settings that travel with a project', () => {
  const chosen = { reality: 0.5, seed: 12, robot: 'callibot', arenaSenses: true } as const;
  const mine = { ...defaultSettings('de'), theme: 'dark', ...chosen } as const;

  it('are those a run depends on; the others stay with the person', () => {
    expect(travelling(mine)).toEqual({ ...defaultProjectSettings, ...chosen });
    const opened = withTravelling(mine, { ...defaultProjectSettings, device: 'calliope-mini-3', seed: 7 });
    const brought = { device: 'calliope-mini-3', reality: 0, seed: 7, robot: 'auto', arenaSenses: false };
    expect(opened).toEqual({ ...mine, ...brought });
  });

  it('are as usual where they name what this app does not have', () => {
    const brought = { ...defaultProjectSettings, device: 'abacus', robot: 'c3po', robotOptions: { c3po: { arm: 'left' } }, seed: 10_000 }; // prettier-ignore
    expect(withTravelling(mine, brought)).toMatchObject({ device: 'auto', robot: 'auto', robotOptions: {}, seed: 1 });
  });
});
