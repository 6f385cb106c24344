/** The command line's entry: reads the words, runs, sets the exit code. */
import { version } from '../../package.json';
import { parseCommand } from './arguments';
import { checkHandIns } from './check/check-command';
import { changeClass } from './class/class-command';
import { convert } from './convert/convert-command';
import { help } from './help';
import { compareProbes } from './probe/compare-command';
import { replay } from './replay/replay';
import { createTerminal } from './terminal';
import { run } from './run';

/** A reader that has closed the pipe (`parcours run … | head`) wants no more output. */
process.stdout.on('error', (error: NodeJS.ErrnoException) => {
  if (error.code === 'EPIPE') process.exit(1);
  throw error;
});

const command = parseCommand(process.argv.slice(2));
switch (command.type) {
  case 'help':
    process.stdout.write(help);
    break;
  case 'version':
    process.stdout.write(`${version}\n`);
    break;
  case 'bad':
    process.stderr.write(`parcours: ${command.problem}\nHelp: npx parcours --help\n`);
    process.exitCode = 2;
    break;
  case 'run':
    process.exitCode = await run(
      command.options,
      createTerminal(process.stdout, process.stderr, command.options.quiet),
    );
    break;
  case 'replay':
    process.exitCode = await replay(
      command.options,
      // A moment is shown alone, without what the program has printed until then.
      createTerminal(process.stdout, process.stderr, command.options.quiet || command.options.stop !== null),
    );
    break;
  case 'check':
    process.exitCode = await checkHandIns(
      command.options,
      createTerminal(process.stdout, process.stderr, command.options.quiet),
    );
    break;
  case 'class':
    process.exitCode = await changeClass(
      command.options,
      createTerminal(process.stdout, process.stderr, command.options.quiet),
    );
    break;
  case 'convert':
    process.exitCode = await convert(command.options, createTerminal(process.stdout, process.stderr, false), (text) =>
      process.stdout.write(text),
    );
    break;
  case 'probe':
    process.exitCode = await compareProbes(command.options, createTerminal(process.stdout, process.stderr, false));
    break;
  default:
    command satisfies never;
}
