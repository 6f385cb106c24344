import { degOf } from '#core/angle';
import type { Vec } from '#core/geometry';
import type { Reading } from '#editor/snap/reading';
import { shownLanguage, t } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import arenaWords from '../words';

/** Formats a length in cm, to the mm, with a true minus sign. */
export const cmText = (mm: number): string => numberText(Math.round(mm) / 10, shownLanguage(), 1).replace('-', '−');

/** A direction in whole degrees, −179 … 180. */
export function degText(deg: number): string {
  const whole = Math.round(deg) + 0;
  return `${String(whole === -180 ? 180 : whole).replace('-', '−')}°`;
}

/** The figures of a gesture, in signs that every language reads. */
export function readingText(reading: Reading): string {
  switch (reading.type) {
    case 'length':
      return `${cmText(reading.mm)} cm${reading.deg === null ? '' : ` · ${degText(reading.deg)}`}`;
    case 'size':
      return `${cmText(reading.width)} × ${cmText(reading.height)} cm`;
    case 'moved':
      return `${movedText(reading.by)} cm`;
    case 'turned':
      return `${reading.byDeg < 0 ? '↻' : '↺'} ${degText(Math.abs(reading.byDeg))}`;
    case 'heading':
      return degText(reading.deg);
    case 'place':
      return `x ${cmText(reading.at.x)} · y ${cmText(reading.at.y)} cm`;
    default:
      return reading satisfies never;
  }
}

/** The figures in words, for screen readers. */
export function readingWords(reading: Reading): string {
  const { figures } = arenaWords;
  switch (reading.type) {
    case 'length':
      return reading.deg === null
        ? t(figures.long, { cm: cmText(reading.mm) })
        : t(figures.length, { cm: cmText(reading.mm), deg: degText(reading.deg) });
    case 'size':
      return t(figures.size, { width: cmText(reading.width), height: cmText(reading.height) });
    case 'moved':
      return t(figures.moved, { x: cmText(reading.by.x), y: cmText(reading.by.y) });
    case 'turned':
      return t(figures.turned, { deg: degText(reading.byDeg) });
    case 'heading':
      return t(figures.heading, { deg: degText(reading.deg) });
    case 'place':
      return t(figures.place, { x: cmText(reading.at.x), y: cmText(reading.at.y) });
    default:
      return reading satisfies never;
  }
}

/** A number that is being typed, with its unit. */
export const typedFieldText = (typed: string, reading: Reading | null): string =>
  `${typed}▏${reading?.type === 'turned' || reading?.type === 'heading' ? '°' : 'cm'}`;

function movedText({ x, y }: Vec): string {
  const along = x === 0 && y !== 0 ? [] : [`${x < 0 ? '←' : '→'} ${cmText(Math.abs(x))}`];
  return [...along, ...(y === 0 ? [] : [`${y < 0 ? '↓' : '↑'} ${cmText(Math.abs(y))}`])].join(' · ');
}

/** Text of the ruler: length and angle, then the place of its end. */
export function measureText(from: Vec, to: Vec): string {
  const place = readingText({ type: 'place', at: to });
  const mm = Math.hypot(to.x - from.x, to.y - from.y);
  if (mm < 0.5) return place;
  const deg = degOf(Math.atan2(to.y - from.y, to.x - from.x));
  return `${readingText({ type: 'length', mm, deg, from })} · ${place}`;
}
