import { plainName } from './by-module';
import { robotTypes } from './index';

/** A robot of lessons that is not here. */
interface OtherRobot {
  readonly name: string;
  /** Its modules and its namespace in MakeCode, spelled plainly (`plainName`). */
  readonly modules: readonly string[];
}

/**
 * Robots with a public library for lessons: the mb… and cp… of github.com/Tiger-Jython/Robotics-Libraries, MiniBit and
 * MOVEMotor of github.com/gmc-code/PC-Microbit-Extension, the MakeCode extensions 4tronix/MiniBit and
 * elecfreaks/pxt-Cutebot-Pro.
 */
const others: readonly OtherRobot[] = [
  { name: '4tronix minibit', modules: ['mbminibit', 'minibit'] },
  { name: '4tronix M.A.R.S. Rover', modules: ['mbmarsrover'] },
  { name: '4tronix Theta:bot', modules: ['mbthetabot'] },
  { name: 'XGO', modules: ['mbxgo'] },
  { name: 'Calliope Rover', modules: ['cprover'] },
  { name: 'Kitronik :MOVE Motor', modules: ['movemotor'] },
  { name: 'Cutebot Pro', modules: ['cutebotpro'] },
];

/** The robot that is not simulated and to which a module belongs; `null`: none that is known. */
export function otherRobotOf(module: string): string | null {
  return others.find(({ modules }) => modules.includes(plainName(module)))?.name ?? null;
}

/** The names of all simulated robots, in the order of the lists, for a sentence. */
export const simulatedNames = (): string => robotTypes.map(({ name }) => name).join(', ');
