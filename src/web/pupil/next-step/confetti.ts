/** Duration of the fall, in ms. */
const FALL_MS = 1500;
const PIECES = 56;
/** Colours of the app that are also distinct on the light floor. */
const COLOURS = ['--accent-line', '--run', '--info', '--brand', '--stop'];

/**
 * Throws a handful of confetti up from the middle of an element, and removes it again. Does nothing for users who
 * prefer less motion. It moves by transforms alone, which the browser does beside the drawing of the arena.
 */
export function throwConfetti(host: HTMLElement): void {
  if (window.matchMedia('(prefers-reduced-motion: reduce)').matches) return;
  const { width } = host.getBoundingClientRect();
  const reach = Math.min(420, width * 0.48);
  for (let i = 0; i < PIECES; i += 1) {
    // The golden ratio spreads them evenly without a pattern.
    const share = (i * 0.618034) % 1;
    const height = 120 + ((i * 97) % 190);
    const acrossPx = (share - 0.5) * 2 * reach;
    const piece = document.createElement('i');
    piece.setAttribute('aria-hidden', 'true');
    piece.style.cssText =
      `position:absolute;left:50%;bottom:100%;width:${String(7 + (i % 3) * 2)}px;height:${String(10 + (i % 4) * 2)}px;` +
      `background:var(${COLOURS[i % COLOURS.length] ?? '--run'});border-radius:${i % 3 === 0 ? '50%' : '2px'};` +
      'pointer-events:none;will-change:transform,opacity;z-index:4';
    host.append(piece);
    const turn = (i % 2 === 0 ? 1 : -1) * (240 + ((i * 53) % 400));
    const falling = piece.animate(
      [
        { transform: 'translate(0, 0) rotate(0)', opacity: 1, easing: 'cubic-bezier(.1,.7,.4,1)' },
        {
          transform: `translate(${String(acrossPx * 0.8)}px, ${String(-height)}px) rotate(${String(turn / 2)}deg)`,
          opacity: 1,
          offset: 0.45,
          easing: 'cubic-bezier(.5,0,.9,.6)',
        },
        { transform: `translate(${String(acrossPx)}px, 20px) rotate(${String(turn)}deg)`, opacity: 0 },
      ],
      { duration: FALL_MS, delay: (i % 7) * 12, fill: 'both' },
    );
    const take = (): void => piece.remove();
    falling.finished.then(take, take);
  }
}
