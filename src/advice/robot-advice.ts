import { robotNamed } from '#robots/by-module';
import { otherRobotOf, simulatedNames } from '#robots/not-simulated';
import type { RobotType } from '#robots/robot';
import type { Source, SyntaxAdvice } from './syntax-advice';

/**
 * Explains an error of a program for a robot whose library is not here, or of a program from MakeCode, whose Python is
 * no MicroPython; `null` in doubt.
 */
export function robotAdvice(type: string, message: string, source: Source | null): SyntaxAdvice | null {
  if (type === 'ImportError' || type === 'ModuleNotFoundError') {
    const name = /^no module named '(\w+)'/.exec(message)?.[1];
    return name === undefined ? null : moduleAdvice(name);
  }
  if (source === null) return null;
  const line = source.text.split('\n')[source.line - 1] ?? '';
  const name = unknownName(type, message, line);
  return name !== null && new RegExp(`\\b${name}\\s*\\.\\s*[A-Za-z_]`).test(line)
    ? makeCodeAdvice(name, source.text)
    : null;
}

/** Advice on a module that is not on the board; `null`: it is none of a robot. */
function moduleAdvice(name: string): SyntaxAdvice | null {
  const robot = robotNamed(name);
  if (robot !== null) return { key: 'error.driverMissing', values: { name, ...ways(robot) } };
  return otherRobot(name) ?? (/^mbrobot_/i.test(name) ? unknownRobot(name) : null);
}

const unknownRobot = (name: string): SyntaxAdvice => ({
  key: 'error.robotUnknown',
  values: { name, robots: simulatedNames() },
});

/** Advice on a word of a robot that is not simulated; `null`: it is none. */
function otherRobot(name: string): SyntaxAdvice | null {
  const of = otherRobotOf(name);
  return of === null ? null : { key: 'error.robotNotSimulated', values: { name, of, robots: simulatedNames() } };
}

const ways = ({ name, modules }: RobotType) => ({ robot: name, module: modules[0] ?? '' });

/** The name that the program lacks. `input` is a function in Python: there an attribute is missing. */
function unknownName(type: string, message: string, line: string): string | null {
  if (type === 'AttributeError')
    return /^'function' object has no attribute/.test(message) && /\binput\s*\./.test(line) ? 'input' : null;
  return type === 'NameError' ? (/^name '(\w+)' (?:isn't|is not) defined/.exec(message)?.[1] ?? null) : null;
}

/** Namespaces of MakeCode for the micro:bit that nothing else is called by (makecode.microbit.org/reference). */
const NAMESPACES = ['basic', 'input', 'pins', 'loops', 'DigitalPin', 'AnalogPin', 'IconNames', 'matrixLidarDistance'];

/** Commands one of which nearly every program of MakeCode has. */
const MARK = /^[^#\n]*\b(?:basic\.(?:forever|pause|show_\w+|clear_screen)|input\.on_\w+|control\.in_background|loops\.every_interval)\b/m; // prettier-ignore
const IMPORT = /^[ \t]*(?:from|import)\b/m;

function makeCodeAdvice(name: string, text: string): SyntaxAdvice | null {
  const robot = robotNamed(name);
  if (robot?.modules.includes(name)) return null; // its import is forgotten
  if (robot !== null) return { key: 'error.makeCodeRobot', values: { name, ...ways(robot) } };
  const other = otherRobot(name);
  if (other !== null) return other;
  if (!NAMESPACES.includes(name) && (!MARK.test(text) || IMPORT.test(text))) return null;
  const driven = Array.from(text.matchAll(/\b([A-Za-z]\w*)\./g), ([, word = '']) => robotNamed(word)).find(Boolean);
  return driven
    ? { key: 'error.makeCodeRobot', values: { name, ...ways(driven) } }
    : { key: 'error.makeCode', values: { name } };
}
