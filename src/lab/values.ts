/** Most runs of a sweep. Chosen: more than a cluster of a school does in a lesson. */
export const MOST_RUNS = 100_000;

type Problem = { readonly problem: string };

/** A decimal number. */
const NUMBER = String.raw`[+-]?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?`;
const STEPS = new RegExp(`^(${NUMBER})\\.\\.(${NUMBER})/(${NUMBER})$`);
const COUNT = new RegExp(`^(${NUMBER})\\.\\.(${NUMBER})#(\\d+)$`);
const ONE = new RegExp(`^${NUMBER}$`);

/** Chosen: doubles have 15 certain digits; what comes after them is the trace of a division. */
const DIGITS = 15;

/**
 * The numbers that a text says: `a..b/step` (up or down), `a..b#n` (so many at equal distances, `#1` is a), or `a,b,c`.
 *
 * @returns or a sentence that begins with the text
 */
export function readNumbers(text: string): { readonly numbers: readonly number[] } | Problem {
  const [, from, to, step] = STEPS.exec(text) ?? [];
  if (from !== undefined && to !== undefined && step !== undefined) return bySteps(text, from, to, step);
  const [, first, last, count] = COUNT.exec(text) ?? [];
  if (first !== undefined && last !== undefined && count !== undefined)
    return byCount(text, Number(first), Number(last), Number(count));
  const numbers = text.split(',').map((one) => one.trim());
  if (numbers.every((one) => ONE.test(one) && Number.isFinite(Number(one))))
    return { numbers: numbers.map((one) => Number(one) + 0) };
  return { problem: `"${text}" is neither like 500..900/50, nor like 500..900#9, nor like 500,650,800.` };
}

function bySteps(text: string, a: string, b: string, by: string): { readonly numbers: readonly number[] } | Problem {
  const [from, to] = [Number(a), Number(b)];
  const isDown = to < from;
  const step = isDown ? Math.abs(Number(by)) : Number(by);
  if (![from, to].every(Number.isFinite) || !(step > 0) || step === Infinity)
    return { problem: `"${text}": with the step ${by} the end is never reached.` };
  const count = Math.floor(Math.abs(to - from) / step + 1e-9) + 1;
  if (count > MOST_RUNS) return tooMany(text, count);
  const places = Math.max(decimalsOf(a), decimalsOf(by));
  const numbers = Array.from({ length: count }, (_, place) => {
    return Number((from + (isDown ? -1 : 1) * place * step).toFixed(places)) + 0;
  });
  return { numbers };
}

function byCount(
  text: string,
  from: number,
  to: number,
  count: number,
): { readonly numbers: readonly number[] } | Problem {
  if (![from, to].every(Number.isFinite) || count < 1) return { problem: `"${text}" has no numbers in it.` };
  if (count > MOST_RUNS) return tooMany(text, count);
  if (count === 1) return { numbers: [from + 0] };
  const last = count - 1;
  const numbers = Array.from({ length: count }, (_, place) =>
    place === 0 ? from + 0 : Number(((from * (last - place) + to * place) / last).toPrecision(DIGITS)) + 0,
  );
  return { numbers };
}

const tooMany = (text: string, count: number): Problem => ({
  problem: `"${text}" has ${count} numbers: at most ${MOST_RUNS} runs.`,
});

/** Digits behind the point of a number as it is written. */
function decimalsOf(text: string): number {
  const [, behind = '', exponent = '0'] = /^[+-]?\d+(?:\.(\d+))?(?:[eE]([+-]?\d+))?$/.exec(text) ?? [];
  return Math.min(100, Math.max(0, behind.length - Number(exponent)));
}
