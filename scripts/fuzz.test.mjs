import { describe, expect, it } from 'vitest';
import { fuzzPlan } from './fuzz.mjs';

describe('npm run fuzz', () => {
  it('tries a million cases of everything unless told otherwise', () => {
    expect(fuzzPlan([])).toEqual({ runs: 1_000_000, folders: [] });
  });

  it('takes a number of cases and folders in any order', () => {
    expect(fuzzPlan(['src/scene', '50_000'])).toEqual({ runs: 50_000, folders: ['src/scene'] });
    expect(fuzzPlan(['20', 'src/scene', 'src/project'])).toEqual({ runs: 20, folders: ['src/scene', 'src/project'] });
  });

  it('refuses to try nothing', () => {
    expect(() => fuzzPlan(['0'])).toThrow('at least one case');
  });
});
