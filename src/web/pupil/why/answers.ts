import type { Texts } from '#core/languages';
import { isSame } from '#core/same';
import type { Cause } from '#simulation/causes/causes';
import type { CodeLine, Output } from '#simulation/causes/output';
import words from './words';

/** The line that has set one thing, or several of a kind together, and since when. */
export interface Answer {
  readonly key: string;
  readonly name: Texts;
  readonly nameValues: Readonly<Record<string, string | number>>;
  /** `null`: nothing has set it; `missing` says so. */
  readonly cause: Cause | null;
  readonly since: Texts | null;
  readonly sinceValues: Readonly<Record<string, string | number>>;
  readonly missing: Texts | null;
}

const WHEELS: readonly Output[] = ['wheel-left', 'wheel-right'];
const LIGHTS: readonly Output[] = ['light-left', 'light-right'];

/** The answer for the drive of the robot: the line that has last set a wheel. */
export function robotAnswer(causes: readonly Cause[]): Answer {
  const wheels = causes.filter(({ output }) => WHEELS.includes(output));
  const [first = null, second = null] = [...wheels].sort((one, other) => other.sinceUs - one.sinceUs);
  if (first === null) return missing('robot', words.names.robot, words.noMotor);
  const stands = wheels.every(({ value }) => value === 0) && second !== null;
  return { ...answerOf('robot', words.names.robot, first), since: stands ? words.since.stands : words.since.drives };
}

/** The answer for one output. */
export function outputAnswer(causes: readonly Cause[], output: Output): Answer {
  const cause = causes.find((one) => one.output === output) ?? null;
  if (cause !== null) return single(cause);
  const { name, values } = nameOf(output);
  return { ...missing(output, name, WHEELS.includes(output) ? words.noMotor : words.notYet), nameValues: values };
}

/** The answer for a line in the console. */
export const printedAnswer = ([cause]: readonly Cause[]): Answer =>
  cause === undefined ? missing('console', words.names.console, words.typed) : single(cause);

/**
 * All that the program has set.
 *
 * @param hasRobot true: its motors are among the answers, too, if nothing has set them
 */
export function allAnswers(causes: readonly Cause[], hasRobot: boolean): readonly Answer[] {
  const pairs = [
    { outputs: WHEELS, key: 'wheels', name: words.names.wheels },
    { outputs: LIGHTS, key: 'lights', name: words.names.lights },
    { outputs: causes.map(({ output }) => output).filter(isColor), key: 'colors', name: words.names.colors },
  ].map(({ outputs, key, name }) => together(causes, outputs, key, name));
  const done = new Set(pairs.flat().flatMap(({ outputs }) => outputs));
  const rest = causes.filter(({ output }) => !done.has(output)).map(single);
  const robot = hasRobot && !causes.some(({ output }) => WHEELS.includes(output)) ? [robotAnswer([])] : [];
  return [...robot, ...pairs.flat().map(({ answer }) => answer), ...rest];
}

const isColor = (output: Output): boolean => output.startsWith('color-');

/** Longest time between the settings that one line makes, in µs: it sets one after the other. */
const AT_ONCE_US = 50_000;

/** The answers for several of a kind: one for all if the same line has set them together, else one for each. */
function together(
  causes: readonly Cause[],
  outputs: readonly Output[],
  key: string,
  name: Texts,
): readonly { readonly outputs: readonly Output[]; readonly answer: Answer }[] {
  const found = causes.filter(({ output }) => outputs.includes(output));
  const [first, ...others] = found;
  if (first === undefined) return [];
  const isOne = ({ sinceUs, lines }: Cause): boolean =>
    Math.abs(sinceUs - first.sinceUs) < AT_ONCE_US && isSame(lines, first.lines);
  const areOne = others.length > 0 && others.every(isOne);
  if (!areOne) return found.map((cause) => ({ outputs: [cause.output], answer: single(cause) }));
  const isWheels = key === 'wheels';
  const stands = found.every(({ value }) => value === 0);
  const base = answerOf(key, name, first);
  const since = stands ? words.since.stands : words.since.drives;
  const areOff = found.every(({ value }) => isOff(value));
  const ofLights = areOff ? words.since.off : words.since.lit;
  return [{ outputs: found.map(({ output }) => output), answer: { ...base, since: isWheels ? since : ofLights } }];
}

function single(cause: Cause): Answer {
  const { name, values } = nameOf(cause.output);
  return { ...answerOf(cause.output, name, cause), nameValues: values };
}

function answerOf(key: string, name: Texts, cause: Cause): Answer {
  const sinceValues = typeof cause.value === 'number' ? { angle: Math.round(cause.value) } : {};
  return { key, name, nameValues: {}, cause, since: sinceOf(cause), sinceValues, missing: null };
}

const missing = (key: string, name: Texts, text: Texts): Answer => ({
  ...{ key, name, nameValues: {}, cause: null, since: null, sinceValues: {} },
  missing: text,
});

function nameOf(output: Output): { readonly name: Texts; readonly values: Answer['nameValues'] } {
  const { names } = words;
  const fixed: Readonly<Record<string, Texts>> = {
    'wheel-left': names.wheelLeft,
    'wheel-right': names.wheelRight,
    'light-left': names.lightLeft,
    'light-right': names.lightRight,
    'board-lights': names.boardLights,
    ...{ display: names.display, sound: names.sound, radio: names.radio, log: names.log, console: names.console },
  };
  const known = fixed[output];
  if (known !== undefined) return { name: known, values: {} };
  const [kind = '', which = ''] = output.split('-');
  if (kind === 'color') return { name: names.color, values: { number: Number(which) + 1 } };
  if (kind === 'motor') return { name: names.motor, values: { number: Number(which) } };
  if (kind === 'servo') return { name: names.servo, values: { port: which } };
  return { name: kind === 'chain' ? names.chain : names.pin, values: { pin: which } };
}

/** True for no light and no level: `0`, `0,0,0`, `off`. */
const isOff = (value: Cause['value']): boolean => value === 'off' || /^0*(,0+)*$/.test(String(value));

function sinceOf({ output, value }: Cause): Texts {
  const { since } = words;
  const off = isOff(value);
  const [kind] = output.split('-');
  if (kind === 'wheel' || kind === 'motor') {
    if (typeof value !== 'number') return since.drives;
    return value === 0 ? since.stands : value > 0 ? since.forward : since.backward;
  }
  if (kind === 'servo') return since.angle;
  if (kind === 'display') return off ? since.dark : since.shows;
  if (kind === 'sound') return off ? since.silent : since.begun;
  if (kind === 'radio') return since.sent;
  if (kind === 'log' || kind === 'console') return since.written;
  if (off) return since.off;
  return kind === 'pin' ? since.on : since.lit;
}

/** The line to go to, and the first line that led there from another file; `null`: none. */
export function placesOf(lines: readonly CodeLine[]): { readonly at: CodeLine | null; readonly from: CodeLine | null } {
  const [at = null] = lines;
  return { at, from: lines.find(({ file }) => file !== at?.file) ?? null };
}
