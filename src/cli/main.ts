/** The command line's entry: reads the words, fetches the command and carries it out, sets the exit code. */
import { version } from '../../package.json';
import { parseCommand, type Asked } from './arguments';
import { createTerminal, type Terminal } from './terminal';
import { loadAhead, type Script } from './threads/thread';

/** A reader that has closed the pipe (`parcours run … | head`) wants no more output. */
process.stdout.on('error', (error: NodeJS.ErrnoException) => {
  if (error.code === 'EPIPE') process.exit(1);
  throw error;
});

const write = (text: string): 0 => {
  process.stdout.write(text);
  return 0;
};

const terminal = (quiet = false): Terminal => createTerminal(process.stdout, process.stderr, quiet);

/** The threads that commands begin with. */
const FIRST: { readonly [Command in Asked['type']]?: Script } = {
  run: 'worker',
  replay: 'worker',
  check: 'check-worker',
  'class add': 'check-worker',
  sweep: 'lab-worker',
  tournament: 'lab-worker',
  hint: 'hint-worker',
};

/** Carries a command out. Its code is fetched now: help and messages need nothing of the simulation. */
async function carryOut(asked: Asked): Promise<number> {
  const first = FIRST[asked.type];
  const onlyJoins = (asked.type === 'check' || asked.type === 'sweep') && asked.options.work === null;
  if (first !== undefined && !onlyJoins) loadAhead(first);
  switch (asked.type) {
    case 'help':
      return write((await import('./commands/help')).helpText(asked.options.about));
    case 'version':
      return write(`${version}\n`);
    case 'completion':
      return write((await import('./commands/completion/completion')).completionFor(asked.options.shell));
    case 'bad':
      process.stderr.write(`parcours: ${asked.problem}\nHelp: ${asked.help}\n`);
      return 2;
    case 'run':
      return (await import('./run')).run(asked.options, terminal(asked.options.quiet));
    case 'replay':
      // A moment is shown alone, without what the program has printed until then.
      return (await import('./replay/replay')).replay(
        asked.options,
        terminal(asked.options.quiet || asked.options.stop !== null),
      );
    case 'check':
      return (await import('./check/check-command')).checkHandIns(asked.options, terminal(asked.options.quiet));
    case 'sweep':
      return (await import('./lab/sweep-command')).sweep(asked.options, terminal(asked.options.quiet));
    case 'hint':
      return (await import('./hint/hint-command')).giveHint(asked.options, terminal());
    case 'tournament':
      return (await import('./lab/tournament-command')).tournament(asked.options, terminal(asked.options.quiet));
    case 'class add':
    case 'class set':
    case 'class merge':
    case 'class report':
      return (await import('./class/class-command')).changeClass(asked.options, terminal(asked.options.quiet));
    case 'convert':
      return (await import('./convert/convert-command')).convert(asked.options, terminal(), write);
    case 'probe compare':
      return (await import('./probe/compare-command')).compareProbes(asked.options, terminal());
    default:
      return asked satisfies never;
  }
}

process.exitCode = await carryOut(parseCommand(process.argv.slice(2)));
