import type { jsPDF } from 'jspdf';
import type { Outline } from '#scene/outline';
import type { Point } from '#scene/scene';

import { CAPITAL } from '../../../pupil/arena/picture/kinds/label';
import type { ToSheet } from './kind';

/** Points of a millimetre, which is what texts are measured in. */
export const PT_PER_MM = 72 / 25.4;

/** How far a circle's control points lie off, for four curves (the usual approximation, right to 0.03 %). */
const ROUND = 0.5522847498;

/** Words around a place, turned counter-clockwise. */
export function write(pdf: jsPDF, text: string, [x, y]: Point, capitalMm: number, turnDeg: number): void {
  const words = printable(text);
  pdf.setFont('helvetica', 'bold');
  pdf.setFontSize((capitalMm / CAPITAL) * PT_PER_MM);
  const turn = (turnDeg * Math.PI) / 180;
  // jsPDF turns about the start of the base line: half the width back and half a capital down, in the text's own frame.
  const [back, down] = [pdf.getTextWidth(words) / 2, capitalMm / 2];
  pdf.text(
    words,
    x - back * Math.cos(turn) + down * Math.sin(turn),
    y + back * Math.sin(turn) + down * Math.cos(turn),
    { angle: turnDeg },
  );
}

/** What stands for signs that the fonts of a PDF lack. */
const PLAIN: Readonly<Record<string, string>> = {
  '−': '–',
  '→': '->',
  '←': '<-',
  '⇒': '=>',
  '≤': '<=',
  '≥': '>=',
  '≠': '!=',
  '≈': '~',
  '\u202f': '\u00a0', // the narrow space of French
};

/** Western letters and signs (Windows-1252): for these every PDF reader has a font. */
const FOREIGN = /[^\u0020-\u007e\u00a0-\u00ff€‚ƒ„…†‡ˆ‰Š‹ŒŽ‘’“”•–—˜™š›œžŸ]/gu;

/** Pictures within a text, with the signs that change or join them, and places where a word may be parted. */
const PICTURES = /(?![\u0020-\u00ff‰™])[\p{Extended_Pictographic}\p{Emoji_Modifier}\ufe0e\ufe0f\u200b-\u200d]|\u00ad/gu;

/** A text in the signs of a PDF's fonts: emojis are left out, and what has no likeness becomes a question mark. */
export const printable = (text: string): string =>
  text
    .normalize('NFC')
    .replace(/[✓✔]/g, '•')
    .replace(PICTURES, '')
    .replace(FOREIGN, (sign) => PLAIN[sign] ?? '?');

/** An outline, closed. */
export function polygon(pdf: jsPDF, outline: Outline, to: ToSheet): void {
  outline.forEach(({ x, y }, i) => {
    const at = to([x, y]);
    if (i === 0) pdf.moveTo(at[0], at[1]);
    else pdf.lineTo(at[0], at[1]);
  });
  pdf.close();
  pdf.stroke();
}

/** The ellipse within a turned rectangle, from four curves. */
export function ellipse(pdf: jsPDF, corners: Outline, to: ToSheet): void {
  const [a, b, , d] = corners;
  if (a === undefined || b === undefined || d === undefined) return;
  const half = { x: (b.x - a.x) / 2, y: (b.y - a.y) / 2 };
  const other = { x: (d.x - a.x) / 2, y: (d.y - a.y) / 2 };
  const centre = { x: a.x + half.x + other.x, y: a.y + half.y + other.y };
  const at = (u: number, v: number): Point =>
    to([centre.x + u * half.x + v * other.x, centre.y + u * half.y + v * other.y]);
  const quarters = [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]] as const; // prettier-ignore
  const start = at(1, 0);
  pdf.moveTo(start[0], start[1]);
  for (let i = 0; i < 4; i += 1) {
    const [[u, v], [nextU, nextV]] = [quarters[i] ?? [1, 0], quarters[i + 1] ?? [1, 0]];
    const [one, two, end] = [
      at(u + ROUND * nextU, v + ROUND * nextV),
      at(nextU + ROUND * u, nextV + ROUND * v),
      at(nextU, nextV),
    ];
    pdf.curveTo(one[0], one[1], two[0], two[1], end[0], end[1]);
  }
  pdf.stroke();
}
