# cmake -DFUZZER=.. -DKIND=.. -DINPUTS=.. -DSOURCE=tests/fuzz -DFOUND=.. -P run_fuzzer.cmake: one fuzzer from its corpus and
# the kept inputs. New inputs go to a folder that is thrown away, so that the corpus stays as it is in the repository. The same inputs
# each time: one seed, a number of inputs and no time, seeds in the order of their names, no numbers of comparisons (they may be
# addresses). A finding by chance is for long campaigns: all.sh.
set(work ${FOUND}/${KIND}-corpus)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
file(GLOB seeds LIST_DIRECTORIES false ${SOURCE}/corpus/${KIND}/* ${SOURCE}/regressions/${KIND}/*)
string(REPLACE ";" "," seeds "${seeds}")
# One input may take 5 s and 2.5 GB: the largest picture that is read is 2 GB. Sanitizers slow things down, a slow or shared
# machine does too; hence six times that.
execute_process(
  COMMAND ${FUZZER} -seed=1 -runs=${INPUTS} -reload=0 -use_cmp=0 -timeout=30 -rss_limit_mb=2560 -max_len=16384 -print_final_stats=1
    -dict=${SOURCE}/${KIND}.dict -artifact_prefix=${FOUND}/${KIND}- -seed_inputs=${seeds} ${work}
  OUTPUT_VARIABLE text ERROR_VARIABLE text RESULT_VARIABLE status)
file(REMOVE_RECURSE ${work})
string(REGEX MATCHALL "stat::number_of_executed_units: [0-9]+" count "${text}")
if(NOT status EQUAL 0)
  string(LENGTH "${text}" length)
  if(length GREATER 12000)
    math(EXPR start "${length} - 12000")
    string(SUBSTRING "${text}" ${start} -1 text)
  endif()
  message(FATAL_ERROR "${text}\nfuzz_${KIND}: a finding; its input is in ${FOUND}. Keep it in tests/fuzz/regressions/${KIND}.")
endif()
message(STATUS "fuzz_${KIND}: no finding; ${count}")
