// Keyword arguments keep the order in which they are written.
import { addressOfText, flat, only, onlyMatch } from './wat.mjs';

/** py/obj.h, mp_map_t: the bit after all_keys_are_qstrs and is_fixed; a dict's map is its second word. */
const IS_ORDERED = 4;

/**
 * C functions of the device get keyword arguments in the order of the call: `log.add(x=1, y=2)` has its columns in that
 * order. Our functions are written in Python, where `**kwargs` is a hash table and loses the order. Here it becomes an
 * ordered table, as in OrderedDict, at the place where mp_setup_code_state makes that dict.
 */
export function orderKeywordArguments(module) {
  const text = addressOfText(module, "function missing required keyword argument '%q'");
  const setUp = only(
    [...module.functions].filter(([, body]) => flat(body).includes(`(i32.const ${text})`)),
    'mp_setup_code_state',
  );
  const [name, body] = [setUp[0], flat(setUp[1])];
  // It makes one dict for that many arguments, and an empty one without arguments.
  const empty = [...body.matchAll(/\(call \$([^\s)]+) \(i32\.const 0\)\)/g)].map((match) => match[1]);
  const made = onlyMatch(
    body,
    'mp_obj_new_dict',
    new RegExp(`\\(call \\$(${empty.map((id) => id.replace('$', '\\$')).join('|')}) \\(local\\.get \\$\\d+\\)\\)`),
  );
  module.functions.set(name, body.replace(made[0], made[0].replace(made[1], 'new_ordered_dict')));
  module.functions.set(
    'new_ordered_dict',
    `(func $new_ordered_dict (param $0 i32) (result i32) (local $1 i32)
      (local.set $1 (call $${made[1]} (local.get $0)))
      (i32.store offset=4 (local.get $1) (i32.or (i32.load offset=4 (local.get $1)) (i32.const ${IS_ORDERED})))
      (local.get $1))`,
  );
}
