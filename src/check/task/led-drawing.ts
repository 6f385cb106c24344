/** Size of an LED, distance between two, and side of the picture, in pixels. */
const [LED, STEP, SIDE] = [3, 4, 5];

/** A picture of the display as a small drawing for a line of text. @param image as a check has it: rows of digits */
export function ledDrawing(image: string): string {
  const rows = image.split(':').map((row, y) =>
    Array.from(row, (digit, x) => {
      const color = digit === '0' ? '#3a4149' : '#ff6a58';
      return `<rect x="${x * STEP + 1}" y="${y * STEP + 1}" width="${LED}" height="${LED}" fill="${color}"/>`;
    }),
  );
  const size = SIDE * STEP + 1;
  return `<svg class="leds" role="img" aria-label="${image}" viewBox="0 0 ${size} ${size}" width="28" height="28"><rect width="${size}" height="${size}" rx="2" fill="#15191d"/>${rows.flat().join('')}</svg>`;
}
