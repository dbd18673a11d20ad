{"empty", "", "1:1: not JSON: a value was expected, but the text ends here\n"},
    {"not-json", "hello", "1:1: not JSON: a value was expected, \"hello\" found\n"},
    {"not-object", "[1]", "1:1: not a scene: a scene is an object, {\"tinker\": 1, ...}\n"},
    {"nan", "{\"tinker\": NaN}", "1:12: not JSON: a value was expected, \"NaN\" found\n"},
    {"infinity", "{\"tinker\": -Infinity}", "1:13: not JSON: a digit was expected, \"Infinity\" found\n"},
    {"trailing-comma", "{\"tinker\": 1,}", "1:13: not JSON: a comma stands before '}' (take it out)\n"},
    {"trailing-comma-of-array", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"},\n ]}",
     "1:42: not JSON: a comma stands before ']' (take it out)\n"},
    {"no-trailing-comma", "{\"tinker\": ]}", "1:12: not JSON: a value was expected, ']' found\n"},
    {"byte-order-mark", "\xEF\xBB\xBF{\"tinker\": 1}",
     "1:1: the text begins with a byte-order mark (save it as UTF-8 without one)\n"},
    {"trailing-text",
     "{\"tinker\": 1}\n"
     "}",
     "2:1: not JSON: the end of the text was expected, '}' found\n"},
    {"leading-zero", "{\"tinker\": 01}", "1:12: not JSON: a number must not begin with a zero that means nothing\n"},
    {"no-digit-behind-point", "{\"tinker\": 1.}", "1:14: not JSON: a digit was expected, '}' found\n"},
    {"control-character", "{\"tinker\": 1, \"title\": \"a\tb\"}",
     "1:26: not JSON: a control character (U+0009) in a text must be written as \\u0009\n"},
    {"bad-escape", "{\"tinker\": 1, \"title\": \"a\\x\"}",
     "1:26: not JSON: a backslash is followed by one of \" \\ / b f n r t u (write \\\\ for a backslash)\n"},
    {"half-surrogate", "{\"tinker\": 1, \"title\": \"\\ud800\"}", "1:25: \\uD800 is half of a surrogate pair\n"},
    {"nul-character", "{\"tinker\": 1, \"title\": \"\\u0000\"}",
     "1:25: the character U+0000 cannot stand in a text of a scene\n"},
    {"bad-utf8", "{\"tinker\": 1, \"title\": \"\377\"}", "1:25: not UTF-8: byte 0xFF cannot stand here\n"},
    {"overlong-utf8", "{\"tinker\": 1, \"title\": \"\300\257\"}", "1:25: not UTF-8: byte 0xC0 cannot stand here\n"},
    {"open-text", "{\"tinker\": 1, \"title\": \"abc", "1:24: not JSON: a text that begins here has no closing quote\n"},
    {"missing-colon", "{\"tinker\" 1}", "1:11: not JSON: ':' behind a key was expected, \"1\" found\n"},
    {"column-counts-characters", "{\"tinker\": 1, \"title\": \"\303\244\303\266\303\274\", x}",
     "1:31: not JSON: a key in double quotes was expected, found x without quotes\n"},
    {"version-missing", "{\"title\": \"a\"}",
     "1:1: not a scene: the key \"tinker\" with the version of the format, 1, is missing\n"},
    {"version-wrong", "{\"tinker\": 2}", "1:12: tinker: the version of the format must be the number 1 (it is 2)\n"},
    {"version-text", "{\"tinker\": \"1\"}",
     "1:12: tinker: the version of the format must be the number 1 (it is \"1\")\n"},
    {"title-number", "{\"tinker\": 1, \"title\": 5}", "1:24: title: a text was expected, a number is given\n"},
    {"units-unknown", "{\"tinker\": 1, \"units\": \"english\"}",
     "1:24: units: \"english\" is not known (did you mean \"English\"?)\n"},
    {"run-not-object", "{\"tinker\": 1, \"run\": \"fast\"}", "1:22: run: an object was expected, a text is given\n"},
    {"run-zero-step", "{\"tinker\": 1, \"run\": {\"step\": 0}}",
     "1:31: run: step must be greater than 0 s (it is 0 s)\n"},
    {"run-negative-step", "{\"tinker\": 1, \"run\": {\"step\": -0.5}}",
     "1:31: run: step must be greater than 0 s (it is -0.5 s)\n"},
    {"run-zero-interval", "{\"tinker\": 1, \"run\": {\"interval\": 0}}",
     "1:35: run: interval must be greater than 0 s (it is 0 s)\n"},
    {"run-negative-duration", "{\"tinker\": 1, \"run\": {\"duration\": \"-3 s\"}}",
     "1:35: run: duration must be greater than 0 s (it is -3 s)\n"},
    {"run-tolerance-zero", "{\"tinker\": 1, \"run\": {\"tolerance\": 0}}",
     "1:36: run: tolerance must be greater than 0 (it is 0)\n"},
    {"run-tolerance-large", "{\"tinker\": 1, \"run\": {\"tolerance\": 1}}",
     "1:36: run: tolerance must be less than 1 (it is 1)\n"},
    {"run-method-number", "{\"tinker\": 1, \"run\": {\"method\": 4}}",
     "1:33: run: method: a text was expected, a number is given\n"},
    {"run-contacts", "{\"tinker\": 1, \"run\": {\"contacts\": \"event\"}}",
     "1:35: run: contacts: \"event\" is not known (did you mean \"events\"?)\n"},
    {"run-radius", "{\"tinker\": 1, \"run\": {\"spectral_radius\": 1.5}}",
     "1:42: run: spectral_radius must be at most 1 (it is 1.5)\n"},
    {"canvas-width", "{\"tinker\": 1, \"canvas\": {\"width\": \"3 kg\", \"grid\": 0, \"snap\": 1}}",
     "1:35: canvas: width: a length (m) was expected, \"3 kg\" is a mass (kg)\n"
     "1:51: canvas: grid must be greater than 0 m (it is 0 m)\n"
     "1:62: canvas: snap: true or false was expected, a number is given\n"},
    {"duplicate-top-key",
     "{\"tinker\": 1, \"title\": \"a\",\n"
     " \"title\": \"b\"}",
     "2:2: the key \"title\" is given twice\n"},
    {"duplicate-escaped-key",
     "{\"tinker\": 1, \"title\": \"a\",\n"
     " \"titl\\u0065\": \"b\"}",
     "2:2: the key \"titl\\u0065\" is given twice\n"},
    {"blocks-not-array", "{\"tinker\": 1, \"blocks\": {}}", "1:25: blocks: an array was expected\n"},
    {"graphs-not-array", "{\"tinker\": 1, \"graphs\": 3}", "1:25: graphs: an array was expected, a number is given\n"},
    {"block-not-object", BLOCKS("3"), "2:1: blocks[0]: a block is an object, {\"type\": ...}\n"},
    {"type-missing", BLOCKS("{\"name\": \"A\"}"), "2:1: A: the key \"type\" is missing\n"},
    {"type-number", BLOCKS("{\"type\": 1, \"name\": \"A\"}"),
     "2:10: A: type: a text was expected, a number is given\n"},
    {"name-number", BLOCKS("{\"type\": \"mass\", \"name\": 1}"),
     "2:26: blocks[0] (mass): name: a text was expected, a number is given\n"},
    {"name-empty", BLOCKS("{\"type\": \"mass\", \"name\": \"\"}"),
     "2:26: blocks[0] (mass): a name must not be empty\n"},
    {"mass-zero", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": 0}"),
     "2:44: Mass 0: mass must be greater than 0 kg (it is 0 kg)\n"},
    {"mass-negative", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": -1}"),
     "2:44: Mass 0: mass must be greater than 0 kg (it is -1 kg)\n"},
    {"mass-nan-text", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": \"nan\"}"),
     "2:44: Mass 0: mass: column 1: a number is expected here, as in 12 or 12 in\n"},
    {"mass-overflow", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": 1e400}"),
     "2:44: Mass 0: mass: the number is too large (at most 1.797e308)\n"},
    {"mass-object", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": {}}"),
     "2:44: Mass 0: mass: a number, or a text with a unit, was expected, an object is given\n"},
    {"mass-null", BLOCKS("{\"type\": \"mass\", \"mass\": null}"),
     "2:26: blocks[0] (mass): mass: a number, or a text with a unit, was expected, null is given\n"},
    {"vector-short", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": [1]}"),
     "2:48: Mass 0: position: a vector has 2 numbers, [x, y], 1 given\n"},
    {"vector-number", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": 1}"),
     "2:48: Mass 0: position: a vector [x, y] was expected, a number is given\n"},
    {"vector-component", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"position\": [1, \"2 s\"]}"),
     "2:52: Mass 0: position: y: a length (m) was expected, \"2 s\" is a time (s)\n"},
    {"wrong-dimension",
     BLOCKS(MASS SUPPORT "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Mass 0\", \"Support 0\"], "
                         "\"stiffness\": \"12 in\"}"),
     "4:86: Spring 0: stiffness: a stiffness (N/m) was expected, \"12 in\" is a length (m)\n"},
    {"unknown-unit", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": \"2 sluk\"}"),
     "2:44: Mass 0: mass: column 3: unknown unit \"sluk\"; did you mean \"slug\"?\n"},
    {"range-as-typed", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": \"-3 lb\", \"height\": -0.5}"),
     "2:44: Mass 0: mass must be greater than 0 kg (it is -3 lb)\n"
     "2:63: Mass 0: height must be at least 0 m (it is -0.5 m)\n"},
    {"restitution-range", BLOCKS("{\"type\": \"support\", \"name\": \"Support 0\", \"restitution\": 1.5}"),
     "2:57: Support 0: restitution must be at most 1 (it is 1.5)\n"},
    {"friction",
     BLOCKS("{\"type\": \"support\", \"name\": \"Support 0\", \"static_friction\": 0.3,\n"
            " \"dynamic_friction\": 0.4}"),
     "3:22: Support 0: dynamic_friction must be at most static_friction, which is 0.3 (it is 0.4)\n"},
    {"friction-one-given", BLOCKS("{\"type\": \"support\", \"name\": \"Support 0\", \"static_friction\": 0.3}"),
     "2:61: Support 0: dynamic_friction must be at most static_friction, which is 0.3 (it is 0.5; dynamic_friction is "
     "not "
     "given: give both)\n"},
    {"switch", BLOCKS("{\"type\": \"support\", \"name\": \"Support 0\", \"solid\": \"yes\"}"),
     "2:51: Support 0: solid: true or false was expected, a text is given\n"},
    {"choice", BLOCKS("{\"type\": \"every-kind\", \"name\": \"Kind\", \"shade\": \"gray\"}"),
     "2:49: Kind: shade: \"gray\" is not known (did you mean \"grey\"?)\n"},
    {"whole-number", BLOCKS("{\"type\": \"every-kind\", \"name\": \"Kind\", \"count\": 2.5}"),
     "2:49: Kind: count must be a whole number (it is 2.5)\n"},
    {"text", BLOCKS("{\"type\": \"every-kind\", \"name\": \"Kind\", \"note\": 2.5}"),
     "2:48: Kind: note: a text was expected, a number is given\n"},
    {"duplicate-name", BLOCKS(MASS "{\"type\": \"mass\", \"name\": \"Mass 0\"}"),
     "3:26: Mass 0: the name \"Mass 0\" is taken: every block needs a name of its own\n"},
    {"duplicate-key", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": 1, \"mass\": 2}"),
     "2:47: Mass 0: the key \"mass\" is given twice\n"},
    {"duplicate-inner-key",
     BLOCKS(MASS
            "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [{\"block\": \"Mass 0\", \"block\": \"Mass 0\"}]}"),
     "3:67: Motor 0: the key \"block\" is given twice\n"},
    {"unknown-end", BLOCKS(MASS "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Mass 0\", \"Mas 0\"]}"),
     "3:59: Spring 0: end 2 names no block \"Mas 0\" (did you mean \"Mass 0\"?)\n"},
    {"ends-on-one-place",
     BLOCKS(MASS "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Mass 0\", \"Mass 0\"]}"),
     "3:59: Spring 0: ends 1 and 2 are both on \"Mass 0\": a spring acts between two places (attach one of them to "
     "another "
     "block)\n"},
    {"end-count", BLOCKS(MASS "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Mass 0\"]}"),
     "3:48: Spring 0: ends: a spring has 2 ends, 1 given\n"},
    {"ends-missing", BLOCKS("{\"type\": \"spring\", \"name\": \"Spring 0\"}"),
     "2:1: Spring 0: ends: a spring has 2 ends, 0 given\n"},
    {"ends-not-wanted", BLOCKS(MASS "{\"type\": \"gravity\", \"name\": \"Gravity\", \"ends\": [\"Mass 0\"]}"),
     "3:48: Gravity: ends: a gravity has no ends, 1 given\n"},
    {"ends-text", BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": \"Mass 0\"}"),
     "3:46: Motor 0: ends: an array of ends was expected, a text is given\n"},
    {"end-number", BLOCKS("{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [5]}"),
     "2:47: Motor 0: end 1: the name of a block, an object or a place was expected, a number is given\n"},
    {"end-object-without-block", BLOCKS("{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [{\"at\": [0, 0]}]}"),
     "2:47: Motor 0: end 1: an end that is an object names its \"block\"\n"},
    {"end-on-field",
     BLOCKS("{\"type\": \"gravity\", \"name\": \"Gravity\"},\n"
            "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Gravity\"]}"),
     "3:47: Motor 0: end 1 is on \"Gravity\", a gravity, which nothing can be attached to\n"},
    {"end-wants-body", BLOCKS(SUPPORT "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Support 0\"]}"),
     "3:47: Motor 0: end 1 must be on a block that can move, \"Support 0\" is a support, which cannot\n"},
    {"end-wants-support", BLOCKS(MASS "{\"type\": \"support-motion\", \"name\": \"Motion\", \"ends\": [\"Mass 0\"]}"),
     "3:55: Motion: end 1 must be on a support, \"Mass 0\" is a mass, which can move\n"},
    {"end-on-itself", BLOCKS("{\"type\": \"every-kind\", \"name\": \"Kind\", \"ends\": [\"Kind\"]}"),
     "2:49: Kind: end 1 is on the block itself\n"},
    {"end-off-centre",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [{\"block\": \"Mass 0\", \"at\": [0.1, 0]}]}"),
     "3:73: Motor 0: end 1 is at [0.1, 0] of \"Mass 0\", which is a point: only [0, 0] is possible\n"},
    {"expression",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"expression\": "
                 "\"2*sin(t\"}}"),
     "3:85: Motor 0: waveform: expression: column 8: an operator, \",\" or \")\" is expected, not the end\n"},
    {"expression-name",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"expression\": "
                 "\"2*sim(t)\"}}"),
     "3:85: Motor 0: waveform: expression: column 3: unknown name \"sim\"; did you mean \"sin\"?\n"},
    {"waveform-word",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": \"sin\"}"),
     "3:70: Motor 0: waveform: \"sin\" is not a waveform (did you mean \"sine\"?)\n"},
    {"waveform-both",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"expression\": "
                 "\"t\", \"table\": \"a.csv\"}}"),
     "3:70: Motor 0: waveform: an object has either \"expression\" or \"table\"\n"},
    {"waveform-number",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": 5}"),
     "3:70: Motor 0: waveform: a waveform (a text or an object) was expected, a number is given\n"},
    {"table-outside",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": "
                 "\"../a.csv\"}}"),
     "3:80: Motor 0: waveform: table: \"../a.csv\" lies outside the scene's folder; a table must be a file in it\n"},
    {"table-absolute",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": "
                 "\"/etc/passwd\"}}"),
     "3:80: Motor 0: waveform: table: \"/etc/passwd\" lies outside the scene's folder; a table must be a file in it\n"},
    {"table-missing",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": \"no "
                 "such file.csv\"}}"),
     "3:80: Motor 0: waveform: table: \"no such file.csv\" cannot be read: No such file or directory\n"},
    {"table-options",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": "
                 "\"a.csv\", \"column\": 0, \"scale\": \"x\",\n"
                 " \"kind\": \"speed\"}}"),
     "3:99: Motor 0: waveform: column must be a whole number from 1 (column 0 is the time)\n"
     "3:111: Motor 0: waveform: scale: column 1: a number is expected here, as in 12 or 12 in\n"
     "4:10: Motor 0: waveform: kind: \"speed\" is not known (it is one of \"value\", \"acceleration\")\n"},
    {"table-kind",
     BLOCKS(MASS "{\"type\": \"motor\", \"name\": \"Motor 0\", \"ends\": [\"Mass 0\"], \"waveform\": {\"table\": "
                 "\"a.csv\", \"kind\": \"acceleration\"}}"),
     "3:80: Motor 0: waveform: a table of accelerations can only move a place, this waveform is a force\n"},
    {"graph-block",
     "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"Mass 0\"}],\n"
     "\"graphs\": [{\"block\": \"Mass 1\", \"quantity\": \"y\"}]}",
     "2:22: graphs[0]: block: there is no block \"Mass 1\" (did you mean \"Mass 0\"?)\n"},
    {"graph-quantity",
     "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"Mass 0\"}],\n"
     "\"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"sped\", \"against\": \"velocity\"}]}",
     "2:44: graphs[0]: quantity: a mass has no quantity \"sped\" (did you mean \"speed\"?)\n"
     "2:63: graphs[0]: against: a mass has no quantity \"velocity\" (it has \"x\", \"y\", \"vx\", \"vy\", \"ax\", "
     "\"ay\", \"speed\", \"kinetic energy\", \"x momentum\", \"y momentum\", \"normal force\", \"friction force\", "
     "\"contact force\", \"acceleration\", \"path length\", \"distance to BLOCK\")\n"},
    {"graph-missing", "{\"tinker\": 1, \"graphs\": [{}, 3]}",
     "1:26: graphs[0]: the key \"block\" is missing\n"
     "1:26: graphs[0]: the key \"quantity\" is missing\n"
     "1:30: graphs[1]: a graph is an object, {\"block\": ..., \"quantity\": ...}\n"},
    {"graph-size",
     "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"Mass 0\"}],\n"
     "\"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"y\", \"size\": [1, 0]}]}",
     "2:57: graphs[0]: size: both numbers must be greater than 0\n"},
    {"warn-many-turns",
     BLOCKS("{\"type\": \"support\", \"name\": \"Support 0\", \"orientation\": 180},\n"
            "{\"type\": \"support\", \"name\": \"Support 1\", \"orientation\": -45},\n"
            "{\"type\": \"support\", \"name\": \"Support 2\", \"orientation\": 6.2},\n"
            "{\"type\": \"support\", \"name\": \"Support 3\", \"orientation\": \"720 deg\"}"),
     "2:57: warning: Support 0: orientation: 180 rad is 28.6 turns (did you mean \"180 deg\"?)\n"
     "3:57: warning: Support 1: orientation: -45 rad is 7.16 turns (did you mean \"-45 deg\"?)\n"},
    {"warn-unknown-type", BLOCKS("{\"type\": \"sping\", \"name\": \"Spring 0\"}"),
     "2:10: warning: Spring 0: no plugin provides the block type \"sping\" (did you mean \"spring\"?)\n"},
    {"warn-unknown-key", BLOCKS("{\"type\": \"mass\", \"name\": \"Mass 0\", \"mas\": 2}"),
     "2:36: warning: Mass 0: unknown key \"mas\" (did you mean \"mass\"?)\n"},
    {"warn-read-only", BLOCKS("{\"type\": \"every-kind\", \"name\": \"Kind\", \"level\": 2}"),
     "2:40: warning: Kind: level is worked out, not set: what is given is ignored\n"},
    {"detached-end", BLOCKS(MASS "{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [[1, 2], \"Mass 0\"]}"), ""},
    {"many",
     BLOCKS("{\"type\": \"spring\", \"name\": \"Spring 0\", \"ends\": [\"Mass 1\", \"Mass 0\"], \"stiffness\": -1},\n"
            "{\"type\": \"mass\", \"name\": \"Mass 0\", \"mass\": 0, \"velocity\": [1, 2, 3]},\n"
            "{\"type\": \"mass\", \"name\": \"Mass 0\", \"mas\": 1, \"mass\": \"1 ft\", \"mass\": 2},\n"
            "{\"type\": \"rod\", \"name\": \"Rod 0\", \"ends\": [\"Mass 0\"]},\n"
            "{\"type\": \"damper\", \"ends\": [\"Mass 0\", \"Mass 2\"], \"damping\": \"x\"}"),
     "2:83: Spring 0: stiffness must be at least 0 N/m (it is -1 N/m)\n"
     "3:44: Mass 0: mass must be greater than 0 kg (it is 0 kg)\n"
     "3:59: Mass 0: velocity: a vector has 2 numbers, [x, y], 3 given\n"
     "4:26: Mass 0: the name \"Mass 0\" is taken: every block needs a name of its own\n"
     "4:36: warning: Mass 0: unknown key \"mas\" (did you mean \"mass\"?)\n"
     "4:54: Mass 0: mass: a mass (kg) was expected, \"1 ft\" is a length (m)\n"
     "4:62: Mass 0: the key \"mass\" is given twice\n"
     "5:42: Rod 0: ends: a rod has 2 ends, 1 given\n"
     "6:39: Damper 0: end 2 names no block \"Mass 2\" (did you mean \"Mass 0\"?)\n"
     "6:61: blocks[4] (damper): damping: column 1: a number is expected here, as in 12 or 12 in\n"},
