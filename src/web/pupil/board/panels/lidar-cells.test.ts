// @vitest-environment happy-dom
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { lidarOf } from '#robots/testing/lidar-of';
import { loadTexts, showLanguage } from '../../../kit/i18n';
import { lidarRows, lookOf } from './lidar-cells';

beforeAll(async () => {
  await loadTexts('de');
  showLanguage('de');
});

describe('the picture of a lidar', () => {
  const lidar = lidarOf({ row: [420, 440, 450, 469, 470, 320, null, 180], asked: [27, 30, 63] });
  const rows = lidarRows(lidar, 'cm');
  const texts = (unit: 'cm' | 'mm', row: number) =>
    lidarRows(lidar, unit)
      [row]?.map(({ text }) => text)
      .join(' ');

  it('has its first row on top and its first column on the left, in whole cm as the program gets them', () => {
    expect(rows.length).toBe(8);
    expect(texts('cm', 0)).toBe('– – – – – – – –');
    expect(texts('cm', 3)).toBe('42 44 45 46 47 32 – 18');
    expect(texts('cm', 7)).toBe('21 21 21 21 21 21 21 21');
  });

  it('has the whole mm, too', () => expect(texts('mm', 3)).toBe('420 440 450 469 470 320 – 180'));

  it('is darker the nearer something is; floor and nothing look otherwise', () => {
    expect(rows[3]?.map(({ look }) => look)).toEqual([2, 2, 3, 3, 3, 2, 'none', 0]);
    expect(rows[7]?.[0]?.look).toBe('floor');
    expect([199, 200, 299, 300, 449, 450, 799, 800].map(lookOf)).toEqual([0, 1, 1, 2, 2, 3, 3, 4]);
  });

  it('says in words what colour and frame say', () => {
    expect(rows[3]?.map(({ said }) => said)).toEqual([
      ...[undefined, undefined, undefined, '46, liest dein Programm', undefined, undefined],
      ...['nichts, liest dein Programm', undefined],
    ]);
    expect([rows[7]?.[0]?.said, rows[7]?.[7]?.said]).toEqual(['21, Boden', '21, Boden, liest dein Programm']);
  });

  it('has 4 × 4 cells where the program has chosen that', () => {
    const few = lidarRows(lidarOf({ row: [100, 200, 300, 400], size: 4 }), 'cm');
    expect(few.map((row) => row.length)).toEqual([4, 4, 4, 4]);
    expect(few[1]?.map(({ text }) => text)).toEqual(['10', '20', '30', '40']);
  });
});

describe('the colours of the picture', () => {
  const tokens = new Map(
    Array.from(readFileSync('src/web/kit/styles/tokens.css', 'utf8').matchAll(/--([\w-]+): #([0-9a-f]{6})/g), ([, name = '', hex = '']) => [name, hex] as const), // prettier-ignore
  );
  /** Relative luminance: WCAG 2.2. */
  const luminance = (name: string): number =>
    [0, 2, 4]
      .map((at) => parseInt(tokens.get(name)?.slice(at, at + 2) ?? 'x', 16) / 255)
      .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
      .reduce((sum, part, at) => sum + part * ([0.2126, 0.7152, 0.0722][at] ?? 0), 0);
  const contrast = (one: string, other: string): number => {
    const [dark = 0, light = 0] = [luminance(one), luminance(other)].sort((a, b) => a - b);
    return (light + 0.05) / (dark + 0.05);
  };

  it.each([
    ['near-ink', 'near-0'],
    ['near-ink', 'near-1'],
    ...['near-2', 'near-3', 'near-4', 'stripe-dark', 'stripe-light'].map((ground) => ['far-ink', ground]),
  ] as [string, string][])('give the number in %s on %s a contrast of 4.5 at least', (ink, ground) =>
    expect(contrast(ink, ground)).toBeGreaterThanOrEqual(4.5),
  );
});
