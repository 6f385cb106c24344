import calliope from '../../../../../courses/board/calliope.py?languages';
import compass from '../../../../../courses/board/compass.py?languages';
import counter from '../../../../../courses/board/counter.py?languages';
import dataLog from '../../../../../courses/board/data-log.py?languages';
import dice from '../../../../../courses/board/dice.py?languages';
import heart from '../../../../../courses/board/heart.py?languages';
import light from '../../../../../courses/board/light.py?languages';
import melody from '../../../../../courses/board/melody.py?languages';
import radio from '../../../../../courses/board/radio.py?languages';
import thermometer from '../../../../../courses/board/thermometer.py?languages';
import type { Texts } from '#core/languages';

/** A sample program for the microcomputer alone: no course, no robot. Its comments and words are in the pupil's language. */
export interface BoardProgram {
  /** Name of its file without `.py`. */
  readonly id: string;
  readonly title: Texts;
  readonly source: Texts;
  /** Id of the only board it runs on, or `null`. */
  readonly board: string | null;
}

/** In the order of the lessons: what is seen, what is pressed, what is felt, what is sent and kept. */
const lessons = [heart, counter, dice, light, thermometer, compass, melody, radio, dataLog, calliope];

/**
 * Every sample program for the microcomputer alone. Imported only where they are offered; nothing needs them before.
 */
export const boardPrograms: readonly BoardProgram[] = lessons.map((program) => ({
  id: program.file.replace('.py', ''),
  title: program.title,
  source: program.source,
  board: program === calliope ? 'calliope-mini-3' : null,
}));

/** True if a text is one of these programs in any language, unchanged. */
export const isBoardProgram = (text: string): boolean =>
  boardPrograms.some(({ source }) => Object.values(source).includes(text));
