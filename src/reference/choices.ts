const GESTURES = [
  ...['shake', 'up', 'down', 'left', 'right', 'face up', 'face down', 'freefall'],
  ...['2g', '3g', '6g', '8g'],
];

/** Strings that an argument can be: key of the function's words → the strings for each argument in turn. */
export const textChoices: Readonly<Record<string, readonly (readonly string[])[]>> = {
  'microbit.accelerometer.is_gesture': [GESTURES],
  'microbit.accelerometer.was_gesture': [GESTURES],
  'builtins.open': [[], ['r', 'w', 'rb', 'wb']],
};
