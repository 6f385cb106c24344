import type { AdviceKey } from './text';

/** One error message of MicroPython: its pattern, the text that explains it, and the values for that text. */
export interface ErrorPattern {
  readonly type: string;
  readonly words: RegExp;
  readonly key: AdviceKey;
  /** Names of the pattern's groups, in their order; the text has them in braces. */
  readonly values?: readonly string[];
}

const when = (type: string, words: RegExp, key: AdviceKey, ...values: readonly string[]): ErrorPattern => ({
  type,
  words,
  key,
  values,
});

const NUMBER = '(?:int|float|bool)';
/** Modules whose name is used without their import. */
const MODULES = 'audio|log|machine|math|microbit|music|neopixel|os|power|radio|random|speech|time';

/** Modules of lessons at a computer that no microcomputer has. */
const COMPUTER =
  '(?:g?turtle|gpanel|gamegrid|tkinter|pygame|numpy|pandas|matplotlib|scipy|sympy|datetime|threading|requests|subprocess|pathlib|itertools|functools|typing|string|statistics|fractions|decimal|csv|sqlite3|keyboard|pyautogui|PIL|cv2|winsound|playsound|asyncio|easygui)';

/**
 * The device's messages that are explained one by one, the special before the general; the first that fits counts.
 * The words are those of MicroPython 1.18 and 1.27 (py/*.c) and of micropython-microbit-v2 src/codal_port; the test
 * makes each of them with a program.
 */
export const errorTable: readonly ErrorPattern[] = [
  when('NameError', /^local variable referenced/, 'error.localUnbound'),
  when('NameError', /'[^']*[“”„‘’«»‹›´`][^']*'/, 'error.curlyQuotes'),
  when('NameError', /'(true|false|none)'/, 'error.nameCapital', 'name'),
  when('NameError', new RegExp(`'(${MODULES})'`), 'error.nameOfModule', 'name'),
  when('NameError', /'([^']+)'/, 'error.NameError', 'name'),
  when('NameError', /(?:)/, 'error.NameErrorAny'),

  when('AttributeError', /^'list' object has no attribute '(?:add|push|addend|insertend)'/, 'error.listAppend'),
  when('AttributeError', /^'(?:list|str|tuple|dict)' object has no attribute '(length|len|size|Length)'/, 'error.useLen', 'name'),
  when('AttributeError', /^'(str|tuple|int|float)' object has no attribute 'append'/, 'error.noAppend', 'owner'),
  when('AttributeError', /^'NoneType' object has no attribute '([^']+)'/, 'error.attributeOfNone', 'name'),
  when('AttributeError', /object has no attribute '__(?:enter|exit)__'/, 'error.withNothing'),
  when('AttributeError', /^'?module.* has no attribute '([^']+)'/, 'error.attributeOfModule', 'name'),
  when('AttributeError', /^(?:type object )?'(?:MicroBit)?([^']+)'.* no attribute '([^']+)'/, 'error.AttributeError', 'owner', 'name'),
  when('AttributeError', /(?:)/, 'error.AttributeErrorAny'),

  when('ImportError', /^can(?:'|no)t import name '?(\w+)/, 'error.importName', 'name'),
  when('ImportError', /'(calliope_?mini)'/, 'error.moduleOfCalliope', 'name'),
  when('ImportError', new RegExp(`'(${COMPUTER}(?:\\.[^']*)?)'`), 'error.moduleOfComputer', 'name'),
  when('ImportError', /'([^']+)'/, 'error.ImportError', 'name'),
  when('ImportError', /(?:)/, 'error.ImportErrorAny'),

  when('TypeError', new RegExp(`^unsupported types for __i?add__: '(?:str', '${NUMBER}|${NUMBER}', 'str)'`), 'error.addTextNumber'),
  when('TypeError', /^unsupported types? for (?!__hash).*'NoneType'/, 'error.operandNone'),
  when('TypeError', /^unsupported types? for .*'(?:bound_method|function|closure)'/, 'error.callForgotten'),
  when('TypeError', new RegExp(`^unsupported types for __(?:lt|le|gt|ge)__: '(?:str', '${NUMBER}|${NUMBER}', 'str)'`), 'error.compareTextNumber'),
  when('TypeError', new RegExp(`^unsupported types for (?:__i?(?:sub|mul|truediv|floordiv|pow|mod)__)?: '(?:str', '${NUMBER}|${NUMBER}', 'str)'`), 'error.textReckon'),
  when('TypeError', new RegExp(`^unsupported types for (?:__\\w+__)?: '(?:tuple', '${NUMBER}|${NUMBER}', 'tuple)'`), 'error.commaNumber'),
  when('TypeError', /^exceptions must derive/, 'error.raiseText'),
  when('TypeError', /^unsupported types for __(?:lt|le|gt|ge)__: '(.+)', '(.+)'/, 'error.compareTypes', 'left', 'right'),
  when('TypeError', /^unsupported types for (?:__\w+__)?: '(.+)', '(.+)'/, 'error.operandTypes', 'left', 'right'),
  when('TypeError', /^unsupported type for __hash__: '(.+)'/, 'error.unhashable', 'type'),
  when('TypeError', /^unsupported type for (?:__\w+__)?: '(.+)'/, 'error.operandType', 'type'),
  when('TypeError', /^'module' object (?:isn't|is not) callable/, 'error.moduleNotCallable'),
  when('TypeError', /^'(.+)' object (?:isn't|is not) callable/, 'error.notCallable', 'type'),
  when('TypeError', /^'int' object (?:isn't|is not) iterable/, 'error.wholeNotIterable'),
  when('TypeError', /^'(.+)' object (?:isn't|is not) iterable/, 'error.notIterable', 'type'),
  when('TypeError', /^'(?:function|bound_method|closure)' object (?:isn't|is not) subscriptable/, 'error.functionSubscript'),
  when('TypeError', /^'(.+)' object (?:isn't|is not) subscriptable/, 'error.notSubscriptable', 'type'),
  when('TypeError', /^'(.+)' object does(?:n't| not) support item (?:assignment|deletion)/, 'error.fixedType', 'type'),
  when('TypeError', /^object of type '(.+)' has no len/, 'error.noLength', 'type'),
  when('TypeError', /indices must be integers/, 'error.indexType'),
  when('TypeError', /^(\w+)\(\) takes (\d+) positional arguments but (\d+) were/, 'error.argumentCount', 'name', 'expected', 'given'),
  when('TypeError', /^function takes (\d+) positional arguments but (\d+) were/, 'error.argumentCountAny', 'expected', 'given'),
  when('TypeError', /^function expected at most (\d+) arguments, got (\d+)/, 'error.argumentCountAny', 'expected', 'given'),
  when('TypeError', /^'(\w+)' argument required/, 'error.argumentRequired', 'name'),
  when('TypeError', /^extra keyword arguments given/, 'error.keywordExtra'),
  when('TypeError', /missing (?:\d+ )?(?:required )?(?:positional|keyword)|^extra positional/, 'error.argumentMissing'),
  when('TypeError', /^unexpected keyword argument '(.+)'/, 'error.keywordUnknown', 'name'),
  when('TypeError', /keyword arguments/, 'error.keywordNone'),
  when('TypeError', /multiple values for argument '(.+)'/, 'error.argumentTwice', 'name'),
  when('TypeError', /^can't convert '?(?:int|float)'?(?: object)? to str/, 'error.textNotNumber'),
  when('TypeError', /^can't convert '?(\w+)'?(?: object)? to str/, 'error.textNeeded', 'type'),
  when('TypeError', /^can't convert NoneType to/, 'error.operandNone'),
  when('TypeError', /^can't convert tuple to (?:int|float)/, 'error.commaNumber'),
  when('TypeError', /^can't convert str to (?:int|float)/, 'error.numberNotText'),
  when('TypeError', /^can't convert float to int/, 'error.numberWhole'),
  when('TypeError', /^can't convert (\w+) to (?:int|float)/, 'error.numberNeeded', 'type'),
  when('TypeError', /^image cannot be modified/, 'error.imageFixed'),
  when('TypeError', /^(?:not an image|expecting an image)/, 'error.imageNeeded'),
  when('TypeError', /^expecting a pin/, 'error.pinNeeded'),
  when('TypeError', /buffer protocol/, 'error.bytesNeeded'),
  when('TypeError', /^format string|not all arguments converted/, 'error.formatCount'),
  when('TypeError', /^ord\(\)/, 'error.oneCharacter'),

  when('ValueError', /^invalid syntax for integer with base \d+: ''/, 'error.wholeOfNothing'),
  when('ValueError', /^invalid syntax for integer with base \d+: '(.*)'/s, 'error.wholeOfText', 'text'),
  when('ValueError', /^invalid syntax for integer with base \d+$/, 'error.wholeOfUnknown'),
  when('ValueError', /^invalid syntax for number/, 'error.numberOfText'),
  when('ValueError', /^too many values to unpack \(expected (\d+)\)/, 'error.unpackMany', 'expected'),
  when('ValueError', /^(?:need more than|wrong number of) (\d+)? ?values/, 'error.unpackFew'),
  when('ValueError', /^Pin (\d+) in display mode/, 'error.pinOfDisplay', 'pin'),
  when('ValueError', /^Pin (\S+) in (\S+) mode/, 'error.pinBusy', 'pin', 'mode'),
  when('ValueError', /^index (?:out of bounds|too large|cannot be negative)/, 'error.pixelIndex'),
  when('ValueError', /^brightness out of bounds/, 'error.brightness'),
  when('ValueError', /^value must be between (-?\d+) and (-?\d+)/, 'error.valueRange', 'least', 'most'),
  when('ValueError', /^value must be 0 or 1/, 'error.valueBit'),
  when('ValueError', /^Invalid angle\. Must be between (\d+) and (\d+)/, 'error.servoAngle', 'least', 'most'),
  when('ValueError', /^Unknown Servo\. Please use (.+) or ('\w+')/, 'error.servoName', 'first', 'last'),
  when('ValueError', /^invalid RGB-LED position\. Must be (.+) or (\d+)/, 'error.rgbPosition', 'first', 'last'),
  when('ValueError', /^value out of range for argument '(.+)'/, 'error.argumentRange', 'name'),
  when('ValueError', /^unknown argument '(.+)'/, 'error.keywordUnknown', 'name'),
  when('ValueError', /^invalid gesture/, 'error.gesture'),
  when('ValueError', /^invalid sound/, 'error.soundEvent'),
  when('ValueError', /^radio is not enabled/, 'error.radioOff'),
  when('ValueError', /^SPI not initialised/, 'error.spiOff'),
  when('ValueError', /^substring not found/, 'error.textNotFound'),
  when('ValueError', /^object not in sequence/, 'error.notInList'),
  when('ValueError', /^math domain error/, 'error.mathDomain'),
  when('ValueError', /^arg is an empty sequence/, 'error.emptySequence'),
  when('ValueError', /^I\/O operation on closed file/, 'error.fileClosed'),
  when('ValueError', /^unexpected character in Image|^image data is incorrect size/, 'error.imageText'),

  when('IndexError', /^pop from empty/, 'error.popEmpty'),
  when('KeyError', /^(.+)$/s, 'error.KeyError', 'name'),
  when('KeyError', /(?:)/, 'error.KeyErrorAny'),

  when('OSError', /\b19\b|ENODEV/, 'error.noDevice'),
  when('OSError', /\b2\b|ENOENT/, 'error.noFile'),
  when('OSError', /\b28\b|ENOSPC/, 'error.boardFull'),
  when('OSError', /\b110\b|ETIMEDOUT/, 'error.timeout'),
  when('OSError', /\b5\b|EIO/, 'error.transfer'),

  when('MemoryError', /allocating (\d{5,}) bytes/, 'error.memoryAtOnce', 'bytes'),
  when('RuntimeError', /^Please connect to (?:Maqueen|a robot)/, 'error.noRobot'),
  when('RuntimeError', /^percent must be from (\d+) to (\d+)/, 'error.valueRange', 'least', 'most'),
  when('RuntimeError', /^no active exception/, 'error.raiseAlone'),
  when('RuntimeError', /recursion|pystack/, 'error.recursion'),
  when('NotImplementedError', /not simulated/, 'error.notSimulated'),

  when('SyntaxError', /^'return' outside|^'yield' outside|^'await' outside/, 'error.returnOutside'),
  when('SyntaxError', /^'break'/, 'error.breakOutside'),
  when('SyntaxError', /^can't assign to/, 'error.assignTarget'),
  when('SyntaxError', /^argument name reused/, 'error.argumentReused'),
  when('SyntaxError', /^non-default argument/, 'error.defaultFirst'),
  when('SyntaxError', /^identifier redefined as (global|nonlocal)/, 'error.globalLate', 'word'),
  when('SyntaxError', /nonlocal/, 'error.nonlocalUnknown'),
  when('SyntaxError', /^invalid syntax for (?:integer|number)/, 'error.digitFirst'),
  when('SyntaxError', /^\*x must be/, 'error.starPlace'),
  when('SyntaxError', /^invalid micropython decorator/, 'error.machineCode'),
  when('IndentationError', /^unexpected indent/, 'error.indentUnexpected'),
  when('IndentationError', /^unindent/, 'error.indentMismatch'),
]; // prettier-ignore
