# shellcheck shell=bash
# Options of a verb are what its usage() says: a line "  -o, --output FILE   text" for each, two blanks before the text. They are held to it
# before anything is installed or built. In a value's name each part between bars is a word as it stands (float|fixed32) or one of
#   BOARD     a board that runs every image          ROBOT     a robot that has a trajectory
#   MODEL     any robot or count model               HEADER    a file that exists
#   MACHINE   any robot, or one of robots/gallery
#   N         a whole number                         NUMBER    a number
#   IN_FILE   a file that exists
#   ANY_BOARD a folder of hal/boards that an emulator runs          WORD      a word of firmware/apps/size/matrix.txt
# With "..." behind it, it may be several, with commas between.
# Other names in capitals take anything. A text that begins with "alone" is of an option that nothing may stand beside.
# What follows a line "maintainers:" is shown by --help --all only.

declare -A OPTION_VALUES OPTION_ALONE # by option: names of its values; whether it stands alone

# shown_usage [--all]
shown_usage() {
  if [[ ${1:-} == --all ]]; then
    usage | sed 's/^maintainers:$/For maintainers:/'
  else
    usage | sed '/^maintainers:$/,$d'
    ! usage | grep -q '^maintainers:$' || echo "Options for maintainers: --help --all"
  fi
}

# Fills OPTION_VALUES and OPTION_ALONE from the text of usage.
read_usage() {
  local line names text
  while IFS= read -r line; do
    [[ $line =~ ^\ \ +(-.*)$ ]] || continue
    names=${BASH_REMATCH[1]}
    text=''
    if [[ $names =~ ^(.*[^\ ])\ \ +(.*)$ ]]; then names=${BASH_REMATCH[1]} text=${BASH_REMATCH[2]}; fi
    read_option_names "$names" "$text"
  done < <(usage)
}

# "-o, --output FILE": both take a FILE; "--states N, --seed N": each its own.
read_option_names() {
  local part name values='' parts=() i
  IFS=',' read -ra parts <<<"$1"
  for ((i = ${#parts[@]} - 1; i >= 0; --i)); do
    read -r name part <<<"${parts[i]}"
    [[ $name == -* ]] || continue
    if [[ $name == --* ]]; then values=$part; fi
    OPTION_VALUES[$name]=${part:-$values}
    OPTION_ALONE[$name]=
    [[ $2 != alone* ]] || OPTION_ALONE[$name]=yes
  done
}

# The arguments without a dash that the first line of usage names: words with capitals between the verb and [options].
positional_names() {
  local line words word
  IFS= read -r line < <(usage)
  read -ra words <<<"${line#usage: ./axial * }"
  [[ $line == "usage: ./axial "*" "* ]] || return 0
  for word in "${words[@]}"; do
    [[ $word == -* || $word == \[* ]] && break
    if [[ $word =~ ^[A-Z] ]]; then echo "$word"; fi
  done
}

# check_positional VERB NAME ARGUMENT: NAME is empty where the verb takes no more. A file that is read must be there.
check_positional() {
  [[ -n $2 ]] || fail_usage "unknown argument '$3'; see ./axial $1 --help"
  case $2 in
    FILE | *.csv) [[ -f $3 || -n ${AXIAL_PARSE_ONLY:-} ]] || fail_usage "there is no file '$3'" ;;
  esac
}

# check_options VERB ARGUMENT...: sets ARGUMENTS, where --name=value has become two.
check_options() {
  local verb=$1 argument value positional=0 total names=()
  shift
  split_values "$@"
  set -- "${ARGUMENTS[@]}"
  total=$#
  read_usage
  mapfile -t names < <(positional_names)
  while (($#)); do
    argument=$1
    shift
    if [[ $argument != -?* ]]; then
      check_positional "$verb" "${names[positional]:-}" "$argument"
      positional=$((positional + 1))
      continue
    fi
    [[ -v OPTION_VALUES[$argument] ]] || fail_usage "unknown option '$argument'; see ./axial $verb --help"
    [[ -z ${OPTION_ALONE[$argument]} ]] || ((total == 1)) || fail_usage "$argument stands alone; see ./axial $verb --help"
    for value in ${OPTION_VALUES[$argument]}; do
      (($#)) || fail_usage "$argument needs a value; see ./axial $verb --help"
      check_value "$argument" "$value" "$1"
      shift
    done
  done
}

split_values() {
  local argument
  ARGUMENTS=()
  for argument; do
    if [[ $argument == --*=* ]]; then
      ARGUMENTS+=("${argument%%=*}" "${argument#*=}")
    else
      ARGUMENTS+=("$argument")
    fi
  done
}

# check_value OPTION NAME VALUE: whether VALUE is what a value of that name may be.
check_value() {
  local kind kinds known=() one
  if [[ $2 == *... ]]; then
    for one in ${3//,/ }; do check_value "$1" "${2%...}" "$one"; done
    return
  fi
  IFS='|' read -ra kinds <<<"$2"
  for kind in "${kinds[@]}"; do
    case $kind in
      N) [[ $3 =~ ^[0-9]+$ ]] && return ;;
      NUMBER) [[ $3 =~ ^-?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$ ]] && return ;;
      IN_FILE) [[ -f $3 || -n ${AXIAL_PARSE_ONLY:-} ]] && return ;;
      HEADER) [[ -n $(own_header "$3") || (${AXIAL_PARSE_ONLY:-} && $3 == *.hpp) ]] && return ;;
      *)
        mapfile -t -O "${#known[@]}" known < <(words_of "$kind")
        [[ $kind =~ ^[A-Z] && ${#known[@]} == 0 || " ${known[*]} " == *" $3 "* ]] && return
        ;;
    esac
  done
  refuse_value "$1" "$2" "$3" "${known[@]}"
}

# words_of KIND: what may stand there; nothing for a kind that takes anything.
words_of() {
  case $1 in
    BOARD) printf '%s\n' "${BOARDS[@]}" ;;
    ROBOT) robots_with_trajectories ;;
    DRIVEN) robots_with_trajectories shared_drives/ ;;
    MODEL) sed -n 's/.*const char\* name = "\([a-z0-9_]*\)";.*/\1/p' "$AXIAL_ROOT"/robots/*.hpp "$AXIAL_ROOT"/robots/models/*.hpp ;;
    MACHINE) find "$AXIAL_ROOT/robots" -name models -prune -o -name '*.hpp' -exec sed -n 's/.*const char\* name = "\([a-z0-9_]*\)".*/\1/p' {} + | sort ;;
    ANY_BOARD) (cd "$AXIAL_ROOT/hal/boards" && grep -lE '"(qemu|runner)"' -- */board.json | sed 's,/.*,,') ;;
    WORD) sed '/^#/d; s/[, ]\+/\n/g' "$AXIAL_ROOT/firmware/apps/size/matrix.txt" | sort -u | sed '/^\**$/d' ;;
    [0-9a-z]*) echo "$1" ;;
  esac
}

# robots_with_trajectories [FOLDER/]
robots_with_trajectories() {
  local file
  for file in "$AXIAL_ROOT/host_sim/robots/trajectories/${1:-}"*.json; do basename "$file" .json; done
}

# refuse_value OPTION NAME VALUE WORD...
refuse_value() {
  local option=$1 name=$2 value=$3
  shift 3
  case $name in
    N) fail_usage "$option is '$value'; give a whole number" ;;
    NUMBER) fail_usage "$option is '$value'; give a number" ;;
    IN_FILE) fail_usage "$option: there is no file '$value'" ;;
    *WORD*) fail_usage "unknown ${option##*-} '$value'; firmware/apps/size/matrix.txt lists what there is" ;;
    *HEADER*) fail_usage "$option: there is no header '$value'${1:+, and no robot called so: $*}" ;;
    *) fail_usage "unknown ${option##*-} '$value'; there are $*" ;;
  esac
}
