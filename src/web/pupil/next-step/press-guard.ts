/** Presses within this time of the one before do nothing, in ms. Chosen: a double press on "next" would skip a mission. */
const REST_MS = 1000;

/** Lets presses through, but a second one within a second: what stands at the place of a button by then is another one. */
export function pressGuard(nowMs: () => number = () => performance.now()): (act: () => void) => void {
  let last = -Infinity;
  return (act) => {
    const now = nowMs();
    if (now - last < REST_MS) return;
    last = now;
    act();
  };
}
