import type { DialectManual, ManualMessage } from '../manual';
import { commandNames, commandSchemas } from './command-schemas';
import { answerSchemas, eventNames, eventSchemas } from './event-schemas';
import type { CommandName, EventName } from './protocol';
import { PROTOCOL_VERSION } from './read-command';

const COMMANDS: Readonly<Record<CommandName, string>> = {
  hello: 'Begins. The page answers only the parent that said hello, and from then on only its origin. May bring a `MessagePort`: then everything else goes over that.', // prettier-ignore
  bye: 'Ends the conversation; the page stays as it is.',
  state: 'Asks where the run stands.',
  subscribe: 'Chooses events and the rate of snapshots.',
  'get-project': 'Asks for the whole work: files, course, settings of the run.',
  'set-project': 'Opens a project, stopped. What the pupil had before stays one click away.',
  'get-files': 'Asks for the files of the program.',
  'set-files': 'Replaces the files of the program; the course stays, a run that is going on ends.',
  'get-scene': 'Asks for the course.',
  'set-scene': 'Opens a course, stopped; the program stays.',
  edit: 'Changes the course by one step, also while the robot drives on it; the pupil can undo it.',
  'get-robot': 'Asks what is chosen to run on.',
  'set-robot': 'Chooses robot, its options, microcomputer, firmware. Another one is another start: a run ends.',
  'get-settings': 'Asks for the settings of the page.',
  settings: 'Sets language, theme, sound, shown parts and words. Nothing of it is kept in the browser.',
  run: 'Starts anew, also while a run is under way. Answered when the program runs; refused when it could not begin.',
  stop: 'Ends the run, also one that has not begun yet; the last picture stays. Answered when it has ended.',
  reset: 'Ends the run, likewise, and puts everything back to the start. Answered when it has ended.',
  pause: 'Lets simulated time stand still.',
  resume: 'Lets it go on.',
  step: 'Lets 20 ms of simulated time pass, from standing still or from the start.',
  speed: 'Chooses how fast simulated time passes; the run comes out the same.',
  seed: 'Chooses which of the used robots drives.',
  reality: 'Chooses how much the robot is like a used one.',
  place: 'The hand puts the robot somewhere during a run. The start is moved by `edit`.',
  'place-block': 'The hand puts a movable block somewhere during a run.',
  press:
    'Presses a button of the board or lets it go, during a run. However soon one follows the other, the board notices both.',
  touch: 'Puts a finger on a pad of the board or takes it away, during a run; likewise.',
  sensor:
    'Sets what a sensor feels. A number holds for later runs as well; a gesture needs a run. Accelerations go up to ±8000 mg; beyond the range that the program has set, the sensor is at its end.',
  'arena-senses': 'Chooses whether the board on the robot feels the arena or what is set by hand.',
  serial: 'Types text into the serial line, for `input()` or the REPL.',
  interrupt: 'KeyboardInterrupt in the program, as Ctrl-C.',
  radio: 'Lets a radio packet arrive.',
  'clear-console': 'Empties the console of the page.',
};

const EVENTS: Readonly<Record<EventName, string>> = {
  phase: 'Where the run stands has changed.',
  started: 'A run begins, by whomever.',
  'program-restarted': 'The program begins anew within its run: Ctrl-D at the REPL.',
  ended: 'The program has ended, with what became of robot and task. The world goes on until `stop`, so a verdict may still change: snapshots have it.', // prettier-ignore
  output: 'The program or the REPL printed. More than 200,000 characters a second are left out and counted.',
  snapshot: 'The run at one moment, at the chosen rate while something moves and the page is visible; the last one before things stand still comes at any rate.', // prettier-ignore
  'scene-changed': 'The course was edited, or is another one, by whomever; `get-scene` brings it.',
  'files-changed': 'A file was changed, by whomever; `get-files` brings them.',
  'settings-changed': 'Settings were changed, by whomever.',
  sensed: 'A person pressed, touched or set something on the page.',
  radio: 'The program sent packets.',
  log: 'The program logged data.',
  refused: 'The run did not take an input.',
  failed: 'The run could not start, or broke inside.',
};

/** What the manual says of our own dialect. */
export const manual: DialectManual = {
  title: 'Parcours',
  version: String(PROTOCOL_VERSION),
  messages: [
    ...commandNames.map((name): ManualMessage => {
      const answer = name in answerSchemas ? answerSchemas[name as keyof typeof answerSchemas] : undefined;
      const message = { name, direction: 'in', schema: commandSchemas[name], about: COMMANDS[name] } as const;
      return answer === undefined ? message : { ...message, answer };
    }),
    ...eventNames.map((name): ManualMessage => ({
      name,
      direction: 'out',
      schema: eventSchemas[name],
      about: EVENTS[name],
    })),
  ],
};
