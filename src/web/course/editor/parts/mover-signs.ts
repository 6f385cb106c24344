import { mdiArrowLeftRightBold, mdiEye, mdiRotateLeft, mdiRunFast, mdiSync } from '@mdi/js';
import type { MoverWay } from '#scene/kinds/mover-way';

/** The icon of each thing that a mover can do. */
export const moverSigns: Readonly<Record<MoverWay, string>> = {
  'to-and-fro': mdiArrowLeftRightBold,
  round: mdiSync,
  stays: mdiRotateLeft,
  chases: mdiRunFast,
  guards: mdiEye,
};
