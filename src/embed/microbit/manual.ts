import { MICROBIT_VERSION, microbitMessages } from './messages';

/** This dialect for the manual. */
export const microbitManual = {
  title: 'The micro:bit dialect',
  version: MICROBIT_VERSION,
  messages: microbitMessages,
} as const;
