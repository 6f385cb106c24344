import { beforeAll, describe, expect, it } from 'vitest';

import { clockText } from './use-run-text';
import { loadTexts } from '../../kit/i18n';
import { factorText, isTooSlow, speedName } from './speed-text';

beforeAll(() => loadTexts('de'));

describe('figures on the page', () => {
  it('show simulated time as minutes, seconds and tenths', () => {
    expect(clockText(0)).toBe('00:00.0');
    expect(clockText(42_690_000)).toBe('00:42.6');
    expect(clockText(3_600_000_000)).toBe('60:00.0');
  });

  it('show a factor with the digits that make sense', () => {
    expect([0.624, 0.999, 1.94, 34.4].map(factorText)).toEqual(['0.62', '1.0', '1.9', '34']);
  });

  it('show slow speeds as fractions', () => {
    expect([0.25, 0.5, 2, 'max'].map((speed) => speedName(speed as 2))).toEqual(['¼×', '½×', '2×', 'max']);
  });

  it('call a machine too slow when it is more than a tenth short', () => {
    expect(isTooSlow(2, 1.79)).toBe(true);
    expect(isTooSlow(2, 1.81)).toBe(false);
    expect(isTooSlow('max', 0.1)).toBe(false);
    expect(isTooSlow(2, null)).toBe(false);
  });
});
