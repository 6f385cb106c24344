import type { jsPDF } from 'jspdf';
import type { Label } from '#scene/scene';

import { CAPITAL } from '../../../pupil/arena/picture/kinds/label';
import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { write } from './pdf-parts';
import { element, escapeXml } from './svg-write';
import type { PrintKind, ToPicture, ToSheet } from './kind';
import { SVG_FONT, turned } from './svg-parts';

/** Words on the floor. */
export const label: PrintKind<Label> = { layer: 2, svg: labelSvg, pdf: printLabel };

function labelSvg({ at, text, height, angle }: Label, to: ToPicture): string {
  return element(
    'text',
    {
      transform: turned(to(at), -angle),
      y: height / 2,
      'font-family': SVG_FONT,
      'font-size': height / CAPITAL,
      'font-weight': 600,
      'text-anchor': 'middle',
      fill: colors.label,
    },
    escapeXml(text),
  );
}

function printLabel(pdf: jsPDF, { text, at, height, angle }: Label, to: ToSheet): void {
  pdf.setTextColor(colors.label);
  write(pdf, text, to(at), height, angle);
}
