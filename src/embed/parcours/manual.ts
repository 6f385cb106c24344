import type { DialectManual, ManualMessage } from '../manual';
import { commandNames, commandSchemas } from './command-schemas';
import { answerSchemas, eventNames, eventSchemas } from './event-schemas';
import type { CommandName, EventName } from './protocol';
import { laterVersion } from './protocol-versions';
import { PROTOCOL_VERSION } from './read-command';

const COMMANDS: Readonly<Record<CommandName, string>> = {
  hello: 'Begins the conversation. The page answers only its parent, and from then on only the origin that said hello. `hello` may carry a `MessagePort`; everything else then goes over that port.', // prettier-ignore
  bye: 'Ends the conversation; the page stays as it is.',
  state: 'Asks for the state of the run.',
  subscribe: 'Chooses which events are sent, and the rate of snapshots.',
  'get-project': 'Asks for the whole work: files, course, settings of the run.',
  'set-project': 'Opens a project, stopped. Earlier work of the pupil stays one click away.',
  'get-files': 'Asks for the files of the program.',
  'set-files': 'Replaces the files of the program. The course stays; a current run ends.',
  'get-scene': 'Asks for the course.',
  'set-scene': 'Opens a course, stopped. The program stays.',
  edit: 'Changes the course by one step, also during a run. The pupil can undo it.',
  'get-robot': 'Asks which robot, microcomputer and firmware are chosen.',
  'set-robot': 'Chooses robot, its options, microcomputer, firmware. A change ends the run.',
  'get-settings': 'Asks for the settings of the page.',
  settings: 'Sets language, theme, sound, shown parts and words. The browser keeps none of these.',
  'set-mode': 'Enters a mode of the arena. Building and looking back pause a run; a start always leads to driving. Refused where the mode is not offered: no building without the part `tools` or where a task locks the course, no past before a run.', // prettier-ignore
  run: 'Starts a new run, also during a run. Answered when the program runs; refused when it cannot begin.',
  stop: 'Ends the run, also one that has not begun yet. The last picture stays. Answered when the run has ended.',
  reset: 'Ends the run, as `stop` does, and puts everything back to the start. Answered when the run has ended.',
  pause: 'Stops simulated time.',
  resume: 'Continues simulated time, from the present.',
  step: 'Lets 20 ms of simulated time pass, from a pause or from the start.',
  'get-break-points': 'Asks where the program stops.',
  'set-break-points': 'Says at which lines the program stops, instead of those that were there; also during a run. They move with their lines while the pupil types, stay with `set-files`, and go when another project or course is opened.', // prettier-ignore
  'get-position': 'Asks where the program is, and for its variables: at the moment that is looked at, else now. Asking changes nothing of the run.', // prettier-ignore
  'step-line': 'Lets a program that stands make a step by lines; all of simulated time stands before and after it. Answered when it has begun; the event `held` says where it has ended. `back`, and any step from a moment of the past, is answered when the line is shown, and refused where there is none.', // prettier-ignore
  'run-to': 'The same, up to the next time that a line begins.',
  'look-at': 'Pauses the run and shows a moment that it has been through: 50 a second are kept.',
  'look-now': 'Shows the present again. The run stands until `resume`.',
  'go-on': 'Lets the run go on from the moment that is looked at, with its whole state; what came after that moment is gone. Answered when the run is there.', // prettier-ignore
  speed: 'Chooses how fast simulated time passes. The result of the run is the same.',
  seed: 'Chooses which of the used robots drives.',
  reality: 'Chooses how much the robot resembles a used one.',
  place: 'Puts the robot somewhere by hand during a run. (`edit` moves its start.)',
  'place-block': 'Puts a movable block somewhere by hand during a run.',
  press:
    'Presses or releases a button of the board during a run. The board notices both, however quickly one follows the other.',
  touch: 'Touches or releases a pad of the board during a run. The board notices both, as with `press`.',
  sensor:
    'Sets what a sensor measures. A number also holds for later runs; a gesture needs a run. Accelerations go up to ±8000 mg; beyond the range that the program has set, the sensor reports its limit.',
  'arena-senses': 'Chooses whether the board on the robot measures the arena or the values set by hand.',
  serial: 'Types text into the serial line, for `input()` or the REPL.',
  interrupt: 'Raises KeyboardInterrupt in the program, like Ctrl-C.',
  radio: 'Delivers a radio packet: to all microcomputers, or to the one that is named.',
  'clear-console': 'Empties the console of the page.',
};

const EVENTS: Readonly<Record<EventName, string>> = {
  phase: 'The state of the run has changed.',
  started: 'A run begins, no matter who started it.',
  'program-restarted': 'The program starts again within its run: Ctrl-D at the REPL.',
  ended: 'The program has ended; the event carries the final state of robot and task. The world goes on until `stop`, so the verdict may still change: see the snapshots.', // prettier-ignore
  output:
    'The program or the REPL printed something. Beyond 200,000 characters a second, output is left out and counted.',
  snapshot: 'The run at one moment. Snapshots come at the chosen rate while something moves and the page is visible. The last one before everything stands still always comes.', // prettier-ignore
  held: 'The program stands before this line: after a break point or a step, also one into the past.',
  looking: 'Another moment of the past is shown, no matter who chose it.',
  'break-points-changed': 'Break points were set or taken away, no matter who did it.',
  'scene-changed': 'The course was edited or replaced, no matter who did it; `get-scene` fetches it.',
  'files-changed': 'A file was changed, no matter who did it; `get-files` fetches the files.',
  'settings-changed': 'Settings were changed, no matter who did it.',
  sensed: 'The user pressed, touched or set something on the page.',
  radio: 'The program sent packets.',
  log: 'The program logged data.',
  refused: 'The run refused an input.',
  failed: 'The run could not start, or failed inside.',
};

/** Our own dialect, for the manual. */
export const manual: DialectManual = {
  title: 'Parcours',
  version: String(PROTOCOL_VERSION),
  messages: [
    ...commandNames.map((name): ManualMessage => {
      const answer = name in answerSchemas ? answerSchemas[name as keyof typeof answerSchemas] : undefined;
      const message = { name, direction: 'in', schema: commandSchemas[name], about: COMMANDS[name], ...laterVersion('commands', name) } as const; // prettier-ignore
      return answer === undefined ? message : { ...message, answer };
    }),
    ...eventNames.map((name): ManualMessage => ({
      name,
      direction: 'out',
      schema: eventSchemas[name],
      about: EVENTS[name],
      ...laterVersion('events', name),
    })),
  ],
};
