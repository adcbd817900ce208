# shellcheck shell=bash
# What the driver says while it works: one line per step; a long silent step shows its elapsed time.

say() { printf 'axial: %s\n' "$*"; }

fail() {
  printf 'axial: %s\n' "$*" >&2
  exit 1
}

fail_usage() {
  printf 'axial: %s\n' "$*" >&2
  exit 2
}

# with_progress TEXT LOG COMMAND...: runs the command into LOG, shows seconds meanwhile and the log's end on failure.
with_progress() {
  local text=$1 log=$2 begin=$SECONDS
  shift 2
  mkdir -p "$(dirname "$log")"
  "$@" >>"$log" 2>&1 </dev/null &
  local process=$!
  show_elapsed "$text" "$process" "$begin"
  if wait "$process"; then
    finish_line "$text: done in $((SECONDS - begin)) s"
  else
    finish_line "$text: failed; the end of $log:"
    tail -n 25 "$log" >&2
    return 1
  fi
}

# On a terminal one line that counts; elsewhere a line every half minute, so that a log stays readable.
show_elapsed() {
  local text=$1 process=$2 begin=$3 next=$((SECONDS + 5))
  [[ -t 1 ]] || say "$text ..."
  while kill -0 "$process" 2>/dev/null; do
    if [[ -t 1 ]]; then
      printf '\raxial: %s ... %d s' "$text" $((SECONDS - begin))
    elif ((SECONDS >= next)); then
      say "$text ... $((SECONDS - begin)) s"
      next=$((SECONDS + 30))
    fi
    sleep 0.2
  done
}

finish_line() {
  [[ -t 1 ]] && printf '\r\033[K'
  say "$*"
}
