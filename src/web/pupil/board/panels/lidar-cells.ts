import { lidarCm } from '#robots/lidar-fan';
import type { LidarState } from '#robots/robot';
import { t } from '../../../kit/i18n';
import type { LidarUnit } from '../../../session/work/settings/settings';
import words from './words';

/** A cell of a lidar's picture. */
export interface LidarCell {
  /** The number of its colour, 0 near … 4 far; `floor` and `none` look otherwise. */
  readonly look: 0 | 1 | 2 | 3 | 4 | 'floor' | 'none';
  /** Its number, or a dash. */
  readonly text: string;
  /** The same in words, where the number alone does not say it. */
  readonly said: string | undefined;
  readonly isAsked: boolean;
}

/** Depths in mm below which a cell has the colours 0, 1, 2, 3; all others have the last one. */
const EDGES_MM = [200, 300, 450, 800] as const;

/** The colour of a depth, by its number. */
export function lookOf(depthMm: number): 0 | 1 | 2 | 3 | 4 {
  const [near, nearer, far, farther] = EDGES_MM;
  if (depthMm < nearer) return depthMm < near ? 0 : 1;
  return depthMm < far ? 2 : depthMm < farther ? 3 : 4;
}

/** The rows of a lidar's picture, from the top. */
export function lidarRows(lidar: LidarState, unit: LidarUnit): readonly (readonly LidarCell[])[] {
  const { size, depthMm, floor, asked } = lidar;
  return Array.from({ length: size }, (_, row) =>
    Array.from({ length: size }, (_, column) => {
      const at = row * size + column;
      return cellOf(depthMm[at] ?? null, floor[at] === true, asked[at] === true, unit);
    }),
  );
}

/** The rows of a picture that has not come yet. */
export const emptyRows = (size: LidarState['size']): readonly (readonly LidarCell[])[] =>
  Array.from({ length: size }, () =>
    Array.from({ length: size }, () => ({ look: 'none' as const, text: '', said: undefined, isAsked: false })),
  );

function cellOf(depthMm: number | null, isFloor: boolean, isAsked: boolean, unit: LidarUnit): LidarCell {
  if (depthMm === null) {
    const nothing = t(words.lidar.nothing);
    return { look: 'none', text: '–', said: isAsked ? t(words.lidar.asked, { value: nothing }) : nothing, isAsked };
  }
  const text = String(unit === 'mm' ? Math.round(depthMm) : lidarCm(depthMm));
  const value = isFloor ? t(words.lidar.floorIs, { value: text }) : text;
  const said = isAsked ? t(words.lidar.asked, { value }) : isFloor ? value : undefined;
  return { look: isFloor ? 'floor' : lookOf(depthMm), text, said, isAsked };
}
