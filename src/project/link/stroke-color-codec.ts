import { firstColors, isFirstColor, type PaintColor } from '#scene/paint/paint';

import { mapped, type Codec, type Columns } from './codec';

/** The codec of the colour of lines as the first links had it; newer colours stand apart (`news-codec.ts`). */
export const strokeColor = (columns: Columns): Codec<PaintColor> =>
  mapped(
    columns.choice(firstColors),
    (color: PaintColor) => (isFirstColor(color) ? color : 'black'),
    (color) => color,
  );
