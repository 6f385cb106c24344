import { collected } from '../../kit/features/feature';
import type { BarItem } from '../../session/layout/bar-item';

/** The items of all features in the bar: each brings a `bar-items.ts`. */
export const barItems: readonly BarItem[] = collected(
  import.meta.glob<readonly BarItem[]>('../../**/bar-items.ts', { eager: true, import: 'barItems' }),
).flat();
