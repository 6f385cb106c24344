/**
 * Python modules for the board that belong to no robot: file name → source. They are our own code and reach everything
 * through the board's own modules and the robots' libraries, as on a real board.
 */
import colour from './colour.py?raw';
import controller from './controller.py?raw';
import huskylens from './huskylens.py?raw';
import simrobot from './simrobot.py?raw';

/** All of them. A robot's library or a file of the project of the same name wins. */
export const freeLibraries: Readonly<Record<string, string>> = {
  'colour.py': colour,
  'controller.py': controller,
  'huskylens.py': huskylens,
  'simrobot.py': simrobot,
};
