import { parseCommand } from '../../arguments';
import { createTerminal } from '../../terminal';
import { convert } from '../convert-command';

/** The output of the command, and its exit code. */
export interface Printed {
  readonly code: number;
  readonly out: string;
  readonly err: string;
}

/** Runs `parcours convert` with these words. */
export async function converted(...words: readonly string[]): Promise<Printed> {
  const command = parseCommand(['convert', ...words]);
  if (command.type !== 'convert') return { code: 2, out: '', err: command.type === 'bad' ? command.problem : '' };
  const [out, err]: [string[], string[]] = [[], []];
  const terminal = createTerminal({ write: (text) => out.push(text) }, { write: (text) => err.push(text) }, false);
  const code = await convert(command.options, terminal, (text) => out.push(text));
  return { code, out: out.join(''), err: err.join('') };
}
