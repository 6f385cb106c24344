/** A link of WebTigerPython, and what it holds. */
export interface LinkSample {
  readonly name: string;
  readonly link: string;
  /** The program as it was packed; empty: the link has none. */
  readonly program: string;
  /** The world as it was packed; `null`: it cannot be read. */
  readonly playground: Readonly<Record<string, unknown>> | null;
}

/**
 * Links in every form that was seen or may come. The worlds are byte for byte those of two public links, on slides of autumn
 * 2025; the programs are ours.
 */
export const linkSamples: readonly LinkSample[] = [
  {
    name: 'four walls, padding missing, + as %2B',
    link: 'https://webtigerpython.ethz.ch/#?code=NobwRAdghgtgpmAXGGUCWEB0AHAnmAGjABMoAXKJMAMwCcB7GAAhgCMHX6yB9bAGwCuAZwBqAZiZoY2erTJMAVAB0IKoXDIBlbHDjEAFADYADAEoVtODvKIVTe02y0MZfQHMNAETRCKEAMZwAIKuYgRMYqbmEA5MxHB8ULj6AKzGZipgAL4AukA&device=micro%3Abit&playground=N4IgygLghgThBCB7AHiAXAbQOwA4sDoBWLARgBYBmSwswgJjpIBoSScd8c6aKBOANjL86tCkwAMAXSYgA6lAA2CxACMAVgFMAxhADO6DBn79xTXln5NCxJv2kZ6OJqScNCTMvcpiS4iu%2BJTOntWLDIWCjpTEnpTKWkQAAcFKABPAHMYRABXADsAEzAASwAvDQMo8SCqqQBfIA',
    program: 'from mbrobot_plusV3 import *\n\nsetSpeed(60)\nrepeat:\n    print(getDistanceAt(3, 3))\n    delay(500)\n',
    playground: {
      StartBox: [787.5714343545221, 1188.8254396462453, 0],
      Wallobjects: [
        [660, 976, 557, 6],
        [528, 718, 225, 4],
        [433, 1035, 570, 2],
        [1174, 1320, 1520, 0],
      ],
      playgroundSize: [2000, 2000],
    },
  },
  {
    name: 'seven walls and a block',
    link: 'https://webtigerpython.ethz.ch/#?code=NobwRAdghgtgpmAXGGUCWEB0AHAnmAGjABMoAXKJMAMwCcB7GAAhgCMHX6yB9bAGwCuAZwBqAZiZoY2erTJMAVAB0IK2nGxxyTACyIVTQ02qyA7lFrEAFAEoDR4nD5RcVgIwAGL3YhGmtNABzAAsyW3tDR2dXADZvFSEyemxwiDAAXwBdIA&device=micro%3Abit&playground=N4IgygLghgThBCB7AHiAXAbQGwCYAcAdFsQOwAsAzFgIxYAMAnGQKwA0We1BDWFzFJEswY5%2BbOgF1WIeABtEAYwDWiAEYArAKYKIAZ3QYMtStxzUcdamUtkcg1tWoUGBPjTp0OTz6wBmUWV1NVkkpEAB1APkNbT0DbCdWfjJWOzpWMikMMjx0hhJ0vD5UrLw8EgdnFJIeEKzzIQdzLCTqPHZ63BxWPCwKknM61gwRClYa9LIGMZxSihTmHBSrBgyJMIAHWSgATwBzGEQAVwA7ABMwAEsAL00DCw9Uj0kAXyA',
    program:
      'from mbrobot_plusV3 import *\n\nrepeat 4:\n    forward()\n    delay(1000)\n    right()\n    delay(600)\nstop()\n',
    playground: {
      StartBox: [628.6667436160945, 681.9635377592535, 0],
      Blockobjects: [[1643.9212014014277, 1139.356100681306, false, 0]],
      Wallobjects: [
        [613, 534, 270, 4],
        [480, 970, 835, 2],
        [887, 1394, 796, 0],
        [1275, 1126, 518, 6],
        [1622, 867, 712, 0],
        [923, 790, 493, 2],
        [834, 524, 149, 4],
      ],
      playgroundSize: [2000, 2000],
    },
  },
  {
    name: 'in the query, the program with padding',
    link: 'https://webtigerpython.ethz.ch/?code=NobwRAdghgtgpmAXGGUCWEB0AHAnmAGjABMoAXKJMAMwCcB7GAAhgCMHX6yB9bAGwCuAZwBqAZiZoY2erTJMAVAB0IKoXDIBlbHDjEAFADYADAEoVtODvKIVTe02y0MZfQHMNAETRCKEAMZwAIKuYgRMYqbmEA5MxHB8ULj6AKzGZipgAL4AukA%3D&device=micro%3Abit&playground=N4IgygLghgThBCB7AHiAXAbQGwCYAcAdFsQOwAsAzFgIxYAMAnGQKwA0We1BDWFzFJEswY5%2BbOgF1WIeABtEAYwDWiAEYArAKYKIAZ3QYMtStxzUcdamUtkcg1tWoUGBPjTp0OTz6wBmUWV1NVkkpEAB1APkNbT0DbCdWfjJWOzpWMikMMjx0hhJ0vD5UrLw8EgdnFJIeEKzzIQdzLCTqPHZ63BxWPCwKknM61gwRClYa9LIGMZxSihTmHBSrBgyJMIAHWSgATwBzGEQAVwA7ABMwAEsAL00DCw9Uj0kAXyA',
    program: 'from mbrobot_plusV3 import *\n\nsetSpeed(60)\nrepeat:\n    print(getDistanceAt(3, 3))\n    delay(500)\n',
    playground: {
      StartBox: [628.6667436160945, 681.9635377592535, 0],
      Blockobjects: [[1643.9212014014277, 1139.356100681306, false, 0]],
      Wallobjects: [
        [613, 534, 270, 4],
        [480, 970, 835, 2],
        [887, 1394, 796, 0],
        [1275, 1126, 518, 6],
        [1622, 867, 712, 0],
        [923, 790, 493, 2],
        [834, 524, 149, 4],
      ],
      playgroundSize: [2000, 2000],
    },
  },
  {
    name: 'a raw + in the fragment',
    link: 'https://webtigerpython.ethz.ch/#?code=NobwRAdghgtgpmAXGGUCWEB0AHAnmAGjABMoAXKJMAMwCcB7GAAhgCMHX6yB9bAGwCuAZwBqAZiZoY2erTJMAVAB0IKoXDIBlbHDjEAFADYADAEoVtODvKIVTe02y0MZfQHMNAETRCKEAMZwAIKuYgRMYqbmEA5MxHB8ULj6AKzGZipgAL4AukA&device=micro%3Abit&playground=N4IgygLghgThBCB7AHiAXAbQOwA4sDoBWLARgBYBmSwswgJjpIBoSScd8c6aKBOANjL86tCkwAMAXSYgA6lAA2CxACMAVgFMAxhADO6DBn79xTXln5NCxJv2kZ6OJqScNCTMvcpiS4iu+JTOntWLDIWCjpTEnpTKWkQAAcFKABPAHMYRABXADsAEzAASwAvDQMo8SCqqQBfIA',
    program: 'from mbrobot_plusV3 import *\n\nsetSpeed(60)\nrepeat:\n    print(getDistanceAt(3, 3))\n    delay(500)\n',
    playground: {
      StartBox: [787.5714343545221, 1188.8254396462453, 0],
      Wallobjects: [
        [660, 976, 557, 6],
        [528, 718, 225, 4],
        [433, 1035, 570, 2],
        [1174, 1320, 1520, 0],
      ],
      playgroundSize: [2000, 2000],
    },
  },
  {
    name: 'the world in the alphabet of addresses',
    link: 'https://webtigerpython.ethz.ch/#?code=NobwRAdghgtgpmAXGGUCWEB0AHAnmAGjABMoAXKJMAMwCcB7GAAhgCMHX6yB9bAGwCuAZwBqAZiZoY2erTJMAVAB0IK2nGxxyTACyIVTQ02qyA7lFrEAFAEoDR4nD5RcVgIwAGL3YhGmtNABzAAsyW3tDR2dXADZvFSEyemxwiDAAXwBdIA&device=micro%3Abit&playground=N4IgygLghgThBCB7AHiAXAbQOwA4sDoBWLARgBYBmSwswgJjpIBoSScd8c6aKBOANjL86tCkwAMAXSYgA6lAA2CxACMAVgFMAxhADO6DBn79xTXln5NCxJv2kZ6OJqScNCTMvcpiS4iu-JTOntWLDIWCjpTEnpTKWkQAAcFKABPAHMYRABXADsAEzAASwAvDQMo8SCqqQBfIA',
    program:
      'from mbrobot_plusV3 import *\n\nrepeat 4:\n    forward()\n    delay(1000)\n    right()\n    delay(600)\nstop()\n',
    playground: {
      StartBox: [787.5714343545221, 1188.8254396462453, 0],
      Wallobjects: [
        [660, 976, 557, 6],
        [528, 718, 225, 4],
        [433, 1035, 570, 2],
        [1174, 1320, 1520, 0],
      ],
      playgroundSize: [2000, 2000],
    },
  },
  {
    name: 'a world alone',
    link: 'https://webtigerpython.ethz.ch/#?device=micro%3Abit&playground=N4IgygLghgThBCB7AHiAXAbQOwA4sDoBWLARgBYBmSwswgJjpIBoSScd8c6aKBOANjL86tCkwAMAXSYgA6lAA2CxACMAVgFMAxhADO6DBn79xTXln5NCxJv2kZ6OJqScNCTMvcpiS4iu%2BJTOntWLDIWCjpTEnpTKWkQAAcFKABPAHMYRABXADsAEzAASwAvDQMo8SCqqQBfIA',
    program: '',
    playground: {
      StartBox: [787.5714343545221, 1188.8254396462453, 0],
      Wallobjects: [
        [660, 976, 557, 6],
        [528, 718, 225, 4],
        [433, 1035, 570, 2],
        [1174, 1320, 1520, 0],
      ],
      playgroundSize: [2000, 2000],
    },
  },
  {
    name: 'a world that was cut off',
    link: 'https://webtigerpython.ethz.ch/#?code=NobwRAdghgtgpmAXGGUCWEB0AHAnmAGjABMoAXKJMAMwCcB7GAAhgCMHX6yB9bAGwCuAZwBqAZiZoY2erTJMAVAB0IKoXDIBlbHDjEAFADYADAEoVtODvKIVTe02y0MZfQHMNAETRCKEAMZwAIKuYgRMYqbmEA5MxHB8ULj6AKzGZipgAL4AukA&device=micro%3Abit&playground=N4IgygLghgThBCB7AHiAXAbQOwA4sDoBWLARgBYBmSwswgJjpIBoSScd8c6a',
    program: 'from mbrobot_plusV3 import *\n\nsetSpeed(60)\nrepeat:\n    print(getDistanceAt(3, 3))\n    delay(500)\n',
    playground: null,
  },
];
