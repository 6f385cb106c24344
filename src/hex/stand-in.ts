/** The Calliope mini's module by its second name, for a board that knows only the first. */
export const STAND_IN = { name: 'calliope_mini.py', text: 'from calliopemini import *\n' } as const;
